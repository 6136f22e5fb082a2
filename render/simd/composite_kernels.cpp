#include "render/simd/composite_kernels.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>

#include "brume/frame.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/composite_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The angle of the point (x, y), in [-pi, pi]; 0 where both are 0. Highway 1.1 has an Atan2, 1.0
// does not.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V Angle(D d, V y, V x) {
  const V across = hn::Max(hn::Abs(x), hn::Set(d, std::numeric_limits<float>::min()));
  const V acute = hn::Atan(d, hn::Div(hn::Abs(y), across));
  const V pi = hn::Set(d, std::numbers::pi_v<float>);
  return hn::CopySign(hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(pi, acute), acute), y);
}

// Where directions fall on a map, and how to mix the four pixels around: for each of a vector of
// directions their columns and rows.
struct MapPositions {
  HWY_ALIGN std::int32_t columns[2][HWY_LANES(float)];
  HWY_ALIGN std::int32_t rows[2][HWY_LANES(float)];
  HWY_ALIGN float fractions[2][HWY_LANES(float)];  // of the right column and of the row below

  // See map_position() and map_radiance().
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE void set(D d, const RadianceMap& map, V x, V y, V z) {
    const hn::RebindToSigned<D> di;
    constexpr float inverse_pi = std::numbers::inv_pi_v<float>;
    const auto width = static_cast<float>(map.width);
    const V azimuth = Angle(d, x, hn::Neg(z));
    const V polar = Angle(d, hn::Sqrt(hn::MulAdd(x, x, hn::Mul(z, z))), y);
    const V across =
        hn::MulAdd(azimuth, hn::Set(d, 0.5f * inverse_pi * width), hn::Set(d, 0.5f * width - 0.5f));
    const V down = hn::MulAdd(polar, hn::Set(d, inverse_pi * static_cast<float>(map.height)),
                              hn::Set(d, -0.5f));
    const V column = hn::Floor(across);
    const V row = hn::Floor(down);
    const auto count = hn::Set(di, map.width);
    const auto last_row = hn::Set(di, map.height - 1);
    const auto first = hn::ConvertTo(di, column);
    const auto left = hn::IfThenElse(hn::Lt(first, hn::Zero(di)), hn::Add(first, count), first);
    const auto right = hn::Add(left, hn::Set(di, 1));
    hn::Store(left, di, columns[0]);
    hn::Store(hn::IfThenElse(hn::Lt(right, count), right, hn::Sub(right, count)), di, columns[1]);
    const auto above = hn::ConvertTo(di, row);
    const auto clamped = [&](auto i)
                             HWY_ATTR { return hn::Min(hn::Max(i, hn::Zero(di)), last_row); };
    hn::Store(clamped(above), di, rows[0]);
    hn::Store(clamped(hn::Add(above, hn::Set(di, 1))), di, rows[1]);
    hn::Store(hn::Sub(across, column), d, fractions[0]);
    hn::Store(hn::Sub(down, row), d, fractions[1]);
  }

  [[nodiscard]] HWY_INLINE glm::vec3 radiance(const RadianceMap& map, std::size_t i) const {
    const auto along = [&](std::int32_t row) HWY_ATTR {
      const glm::vec3& left = map.pixel(columns[0][i], row);
      return left + fractions[0][i] * (map.pixel(columns[1][i], row) - left);
    };
    const glm::vec3 above = along(rows[0][i]);
    return above + fractions[1][i] * (along(rows[1][i]) - above);
  }
};

void FindSky(const RadianceMap& map, float scale, const RowDirections& directions,
             std::span<const float> distances, std::span<glm::vec3> behind) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  const glm::vec3& start = directions.start;
  const glm::vec3& step = directions.per_pixel;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  MapPositions positions;
  for (std::size_t first = 0; first < distances.size(); first += lanes) {
    const std::size_t end = std::min(first + lanes, distances.size());
    std::size_t k = first;
    while (k < end && distances[k] < infinite) ++k;
    if (k == end) continue;
    const int pixel = directions.first + static_cast<int>(first);
    const auto lane = hn::Iota(d, static_cast<float>(pixel));
    positions.set(d, map, hn::MulAdd(lane, hn::Set(d, step.x), hn::Set(d, start.x)),
                  hn::MulAdd(lane, hn::Set(d, step.y), hn::Set(d, start.y)),
                  hn::MulAdd(lane, hn::Set(d, step.z), hn::Set(d, start.z)));
    for (; k < end; ++k) {
      if (!(distances[k] < infinite)) behind[k] = scale * positions.radiance(map, k - first);
    }
  }
}

// Whole vectors of pixels from `k` on. Returns where it ended.
template <class D>
HWY_INLINE std::size_t CompositePixels(D d, const RowLayers& layers,
                                       std::span<const glm::vec3> behind, std::size_t k,
                                       std::span<float> beauty) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f);
  const V infinite = hn::Set(d, std::numeric_limits<float>::infinity());
  for (; k + hn::Lanes(d) <= layers.depth.size(); k += hn::Lanes(d)) {
    V light[3];
    V transmitted[3];
    V emitted[3];
    hn::LoadInterleaved3(d, layers.airlight.data() + 3 * k, light[0], light[1], light[2]);
    hn::LoadInterleaved3(d, layers.transmittance.data() + 3 * k, transmitted[0], transmitted[1],
                         transmitted[2]);
    hn::LoadInterleaved3(d, &behind[k].x, emitted[0], emitted[1], emitted[2]);
    V sum[3];
    for (int c = 0; c < 3; ++c) {
      const V x = hn::MulAdd(transmitted[c], emitted[c], light[c]);
      sum[c] = hn::IfThenElseZero(hn::Eq(x, x),
                                  hn::Min(hn::Max(x, hn::Zero(d)), hn::Set(d, max_radiance)));
    }
    const V depth = hn::LoadU(d, layers.depth.data() + k);
    const V alpha = hn::IfThenElse(hn::Lt(depth, infinite), one, hn::Sub(one, transmitted[0]));
    hn::StoreInterleaved4(sum[0], sum[1], sum[2], alpha, d, beauty.data() + 4 * k);
  }
  return k;
}

void CompositeRow(const RowLayers& layers, std::span<const glm::vec3> behind,
                  std::span<float> beauty) {
  const std::size_t k = CompositePixels(hn::ScalableTag<float>(), layers, behind, 0, beauty);
  CompositePixels(hn::CappedTag<float, 1>(), layers, behind, k, beauty);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(FindSky);
HWY_EXPORT(CompositeRow);

void find_sky(const RadianceMap& map, float scale, const RowDirections& directions,
              std::span<const float> distances, std::span<glm::vec3> behind) {
  HWY_DYNAMIC_DISPATCH(FindSky)(map, scale, directions, distances, behind);
}

void composite_row(const RowLayers& layers, std::span<const glm::vec3> behind,
                   std::span<float> beauty) {
  HWY_DYNAMIC_DISPATCH(CompositeRow)(layers, behind, beauty);
}

}  // namespace brume
#endif
