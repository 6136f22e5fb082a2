#include "render/scattering/incident_lookup.h"

#include <algorithm>
#include <tuple>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/scattering/incident_lookup.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/scattering/grid_cells-inl.h"
#include "render/simd/sh_basis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t node_floats = std::tuple_size_v<NodeRadiance>;

// Calls visit(i, level, first corner, corner weights) for points first + i, Lanes(Points()) of
// them at most.
template <class Visit>
HWY_INLINE void ForEachCell(std::span<const GridLevel> levels, const SurfacePoints& points,
                            std::size_t first, const Visit& visit) {
  const Points d;
  using V = hn::Vec<Points>;
  const float* positions[] = {points.position.x.data() + first, points.position.y.data() + first,
                              points.position.z.data() + first};
  const float* normals[] = {points.normal.x.data() + first, points.normal.y.data() + first,
                            points.normal.z.data() + first};
  const auto coordinate = [&](const GridLevel& level, int k) HWY_ATTR {
    const V p = hn::LoadU(d, positions[k]);
    return hn::Mul(hn::Set(d, level.per_unit), hn::Sub(p, hn::Set(d, level.first[k])));
  };
  // At this distance from a plane the nearest node is on the same side [cells].
  V reach = hn::Zero(d);
  if (std::ranges::any_of(levels, [](const GridLevel& level) { return level.blocked; })) {
    for (const float* n : normals) reach = hn::Add(reach, hn::Abs(hn::LoadU(d, n)));
    reach = hn::Mul(hn::Set(d, 0.5f), reach);
  }
  const auto moved = [&](V x, int k)
                         HWY_ATTR { return hn::MulAdd(reach, hn::LoadU(d, normals[k]), x); };
  const Cells cells(levels, coordinate, moved, hn::Set(d, 1.0f));
  for (std::size_t i = 0; i < std::min(hn::Lanes(d), points.count - first); ++i) {
    const GridLevel& level = levels[static_cast<std::size_t>(cells.level[i])];
    const std::size_t k = first + i;
    float corner_weights[8];
    cells.CornerWeights(i, corner_weights);
    if (level.blocked) {
      HideCorners(
          level, cells.node[i],
          cells.EyeCorner(level, i, points.to_eye.x[k], points.to_eye.y[k], points.to_eye.z[k]),
          corner_weights);
    }
    visit(i, level, cells.node[i], corner_weights);
  }
}

void FindIncident(std::span<const GridLevel> levels, const SurfacePoints& points,
                  std::span<NodeRadiance> light) {
  for (std::size_t first = 0; first < points.count; first += hn::Lanes(Points())) {
    ForEachCell(levels, points, first,
                [&](std::size_t i, const GridLevel& level, std::int32_t node,
                    const float(&corner_weights)[8]) HWY_ATTR {
                  NodeRadiance& at = light[first + i];
                  at.fill(0.0f);
                  AddNodes<node_floats, node_floats>(level.incident, level, node, corner_weights,
                                                     at.data());
                });
  }
}

void FindDiffuse(std::span<const GridLevel> levels, const SurfacePoints& points,
                 const DiffuseFactors& factors, PointRadiance& radiance) {
  constexpr int bands = 5;
  constexpr std::size_t held = sh_size(3);  // the fourth band is nothing to a diffuse surface
  const Points d;
  const hn::CappedTag<float, 4> rgb;
  alignas(64) float basis[sh_size(bands)][max_points];
  const bool has_sky = factors.bands[4] != 0.0f;
  for (std::size_t first = 0; first < points.count; first += hn::Lanes(d)) {
    FindBasis<bands>(d, hn::LoadU(d, points.normal.x.data() + first),
                     hn::LoadU(d, points.normal.y.data() + first),
                     hn::LoadU(d, points.normal.z.data() + first), factors.bands, basis);
    ForEachCell(
        levels, points, first,
        [&](std::size_t i, const GridLevel& level, std::int32_t node,
            const float(&corner_weights)[8]) HWY_ATTR {
          alignas(64) float light[node_floats] = {};
          AddNodes<node_floats, 4 * held>(level.incident, level, node, corner_weights, light);
          alignas(16) float sent[4];
          for (std::size_t c = 0; c < 4; c += hn::Lanes(rgb)) {
            auto sum = hn::Zero(rgb);
            for (std::size_t f = 0; f < held; ++f) {
              sum = hn::MulAdd(hn::Set(rgb, basis[f][i]), hn::Load(rgb, light + 4 * f + c), sum);
            }
            if (has_sky) {
              auto fifth = hn::Zero(rgb);
              for (std::size_t f = sh_size(4); f < sh_size(bands); ++f) {
                const float* sky = factors.fifth_band.data() + 4 * (f - sh_size(4)) + c;
                fifth = hn::MulAdd(hn::Set(rgb, basis[f][i]), hn::LoadU(rgb, sky), fifth);
              }
              const auto mean =
                  hn::Mul(hn::LoadU(rgb, factors.per_mean.data() + c), hn::Load(rgb, light + c));
              sum = hn::MulAdd(hn::Min(mean, hn::Set(rgb, 1.0f)), fifth, sum);
            }
            hn::Store(hn::Max(sum, hn::Zero(rgb)), rgb, sent + c);
          }
          radiance.r[first + i] = sent[0];
          radiance.g[first + i] = sent[1];
          radiance.b[first + i] = sent[2];
        });
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(FindIncident);
HWY_EXPORT(FindDiffuse);

void IncidentLookup::incident(const SurfacePoints& points, std::span<NodeRadiance> light) const {
  HWY_DYNAMIC_DISPATCH(FindIncident)(levels_.all(), points, light);
}

void IncidentLookup::diffuse(const SurfacePoints& points, const DiffuseFactors& factors,
                             PointRadiance& radiance) const {
  HWY_DYNAMIC_DISPATCH(FindDiffuse)(levels_.all(), points, factors, radiance);
}

}  // namespace brume
#endif
