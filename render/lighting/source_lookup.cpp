#include "render/lighting/source_lookup.h"

#include <algorithm>
#include <cmath>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/lighting/source_lookup.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The cell of a grid that holds a point, and where in it.
struct Cell {
  const float* corner;
  std::ptrdiff_t row, slab;
  float corner_weights[8];  // of its corners, x fastest

  // `coordinate`: in cells from the first node; `size`: floats in a node. `to_eye`: unit, to hide
  // what surfaces do from there; 0: hides nothing.
  Cell(const SourceLookup::Level& level, const float* values, const glm::vec3& coordinate,
       std::ptrdiff_t size, const glm::vec3& to_eye)
      : corner(values), row(size * level.count.x), slab(row * level.count.y) {
    const std::ptrdiff_t step[] = {size, row, slab};
    float f[3];
    std::size_t low_node[3];
    for (int k = 0; k < 3; ++k) {
      const auto last = static_cast<float>(level.count[k] - 2);
      const float x = std::min(std::max(coordinate[k], 0.0f), last + 1.0f);
      const float low = std::min(static_cast<float>(static_cast<int>(x)), last);
      corner += static_cast<std::ptrdiff_t>(low) * step[k];
      low_node[k] = static_cast<std::size_t>(low);
      f[k] = x - low;
    }
    for (int i = 0; i < 8; ++i) {
      corner_weights[i] = ((i & 1) != 0 ? f[0] : 1.0f - f[0]) *
                          ((i & 2) != 0 ? f[1] : 1.0f - f[1]) * ((i & 4) != 0 ? f[2] : 1.0f - f[2]);
    }
    if (!level.blocked || to_eye == glm::vec3(0.0f)) return;
    int nearest = 0;
    for (int k = 0; k < 3; ++k) nearest |= (f[k] + eye_reach * to_eye[k] > 0.5f ? 1 : 0) << k;
    HideCorners(level, low_node, nearest);
  }

  // The nearest node to a point at this distance from a plane is on the same side [cells].
  static float Reach(const glm::vec3& normal) {
    return 0.5f * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
  }

 private:
  // Drops the corners that one does not see: the nearest to where the eye's ray comes from, since
  // the nearest to the point itself may be in a wall.
  void HideCorners(const SourceLookup::Level& level, const std::size_t (&low_node)[3],
                   int nearest) {
    const auto bit = [](int corner_index, int k) { return corner_index >> k & 1; };
    std::size_t node = 0;
    for (int k = 3; k-- > 0;) {
      node = node * static_cast<std::size_t>(level.count[k]) + low_node[k] +
             static_cast<std::size_t>(bit(nearest, k));
    }
    const std::uint32_t blocked = level.blocked[node];
    if (blocked == 0) return;
    float sum = 0.0f;
    for (int i = 0; i < 8; ++i) {
      const int link = neighbour_index(bit(i, 0) - bit(nearest, 0), bit(i, 1) - bit(nearest, 1),
                                       bit(i, 2) - bit(nearest, 2));
      if ((blocked >> link & 1u) != 0) corner_weights[i] = 0.0f;
      sum += corner_weights[i];
    }
    if (sum > 0.0f) {
      for (float& weight : corner_weights) weight /= sum;
    } else {
      corner_weights[nearest] = 1.0f;
    }
  }
};

bool Holds(const SourceLookup::Level& level, const glm::vec3& coordinate) {
  return coordinate.x >= 0.0f && coordinate.y >= 0.0f && coordinate.z >= 0.0f &&
         coordinate.x <= static_cast<float>(level.count.x - 1) &&
         coordinate.y <= static_cast<float>(level.count.y - 1) &&
         coordinate.z <= static_cast<float>(level.count.z - 1);
}

// The cell of the finest level that holds a point, of nodes of `size` floats; moved by `offset`
// cells.
Cell CellAt(std::span<const SourceLookup::Level> levels, const float* SourceLookup::Level::*values,
            const glm::vec3& p, std::ptrdiff_t size, const glm::vec3& to_eye,
            const glm::vec3& offset = glm::vec3(0.0f)) {
  const SourceLookup::Level* level = levels.data();
  glm::vec3 coordinate = level->per_unit * (p - level->first);
  if (levels.size() > 1 && !Holds(*level, coordinate)) {
    ++level;
    coordinate = level->per_unit * (p - level->first);
  }
  return {*level, level->*values, coordinate + offset, size, to_eye};
}

// What a cell has at its point, from float i of its nodes on.
template <std::size_t size, class D>
HWY_INLINE hn::Vec<D> Mixed(const Cell& cell, D d, std::size_t i) {
  auto value = hn::Zero(d);
  for (std::size_t c = 0; c < 8; ++c) {
    const float* node =
        cell.corner + i + (c & 1) * size + (c >> 1 & 1) * cell.row + (c >> 2) * cell.slab;
    value = hn::MulAdd(hn::Set(d, cell.corner_weights[c]), hn::LoadU(d, node), value);
  }
  return value;
}

// In vectors of no more floats than nodes have.
template <int bands, bool has_narrow_clusters>
HWY_INLINE glm::vec3 Sum(std::span<const SourceLookup::Level> levels, const glm::vec3& w,
                         std::span<const float> t, std::span<const float> sample_weights,
                         const SourceWeights& weights) {
  constexpr std::size_t size = SourceGrid::node_size(bands);
  constexpr std::size_t harmonics = 4 * sh_size(bands);
  constexpr std::size_t used = has_narrow_clusters ? size : harmonics;
  const hn::CappedTag<float, (size < 16 ? size : 16)> d;
  float sums[used] = {};
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (!(sample_weights[k] > 0.0f)) continue;
    const Cell cell = CellAt(levels, &SourceLookup::Level::values, t[k] * w, size, -w);
    const auto sample_weight = hn::Set(d, sample_weights[k]);
    for (std::size_t i = 0; i < used; i += hn::Lanes(d)) {
      hn::StoreU(hn::MulAdd(sample_weight, Mixed<size>(cell, d, i), hn::LoadU(d, sums + i)), d,
                 sums + i);
    }
  }
  glm::vec3 result(0.0f);
  for (std::size_t i = 0; i < harmonics; i += 4) {
    const float* weight = weights.harmonics.data() + i;
    result += glm::vec3(weight[0] * sums[i], weight[1] * sums[i + 1], weight[2] * sums[i + 2]);
  }
  for (std::size_t f = harmonics; f < used; ++f) {
    result += sums[f] * weights.narrow[f - harmonics];
  }
  return result;
}

void ClusterTransmittanceAtOrigin(std::span<const SourceLookup::Level> levels,
                                  SourceLookup::ClusterTransmittance& passes) {
  const SourceLookup::Level& coarsest = levels.back();
  if (!Holds(coarsest, -coarsest.per_unit * coarsest.first)) {
    passes.fill(1.0f);
    return;
  }
  constexpr std::size_t size = SourceGrid::node_size(PhaseBands::max_bands);
  const hn::CappedTag<float, 16> d;
  const Cell cell =
      CellAt(levels, &SourceLookup::Level::values, glm::vec3(0.0f), size, glm::vec3(0.0f));
  for (std::size_t i = 0; i < source_clusters; i += hn::Lanes(d)) {
    hn::StoreU(Mixed<size>(cell, d, size - source_clusters + i), d, passes.data() + i);
  }
}

// n and to_eye: 0 to look up at p itself, of all nodes.
void MixIncident(std::span<const SourceLookup::Level> levels, const glm::vec3& p,
                 const glm::vec3& n, const glm::vec3& to_eye, float* values) {
  constexpr std::size_t size = std::tuple_size_v<NodeRadiance>;
  const hn::CappedTag<float, 16> d;
  const Cell cell =
      CellAt(levels, &SourceLookup::Level::incident, p, size, to_eye, Cell::Reach(n) * n);
  for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
    hn::StoreU(Mixed<size>(cell, d, i), d, values + i);
  }
}

glm::vec3 SumSource(int bands, std::span<const SourceLookup::Level> levels, const glm::vec3& w,
                    std::span<const float> t, std::span<const float> sample_weights,
                    const SourceWeights& weights) {
  constexpr int max_bands = PhaseBands::max_bands;
  if (bands == 1) return Sum<1, false>(levels, w, t, sample_weights, weights);
  return weights.has_narrow_clusters ? Sum<max_bands, true>(levels, w, t, sample_weights, weights)
                                     : Sum<max_bands, false>(levels, w, t, sample_weights, weights);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(SumSource);
HWY_EXPORT(ClusterTransmittanceAtOrigin);
HWY_EXPORT(MixIncident);

SourceLookup::SourceLookup(const SourceGrid& grid, const glm::dvec3& origin)
    : bands_(grid.bands()) {
  for (const SourceGrid::Level& level : grid.levels()) {
    levels_[count_++] = {glm::vec3(level.first - origin),
                         1.0f / level.nodes.spacing,
                         level.nodes.count,
                         level.values.data(),
                         level.incident.data(),
                         level.surfaces && !level.surfaces->blocked().empty()
                             ? level.surfaces->blocked().data()
                             : nullptr};
  }
}

glm::vec3 SourceLookup::operator()(const glm::vec3& w, std::span<const float> t,
                                   std::span<const float> sample_weights,
                                   const SourceWeights& weights) const {
  return HWY_DYNAMIC_DISPATCH(SumSource)(bands_, std::span(levels_).first(count_), w, t,
                                         sample_weights, weights);
}

SourceLookup::ClusterTransmittance SourceLookup::cluster_transmittance() const {
  ClusterTransmittance passes;
  HWY_DYNAMIC_DISPATCH(ClusterTransmittanceAtOrigin)(std::span(levels_).first(count_), passes);
  return passes;
}

NodeRadiance SourceLookup::incident(const glm::vec3& p) const {
  return incident_before(p, glm::vec3(0.0f), glm::vec3(0.0f));
}

NodeRadiance SourceLookup::incident_before(const glm::vec3& p, const glm::vec3& n,
                                           const glm::vec3& to_eye) const {
  NodeRadiance light;
  HWY_DYNAMIC_DISPATCH(MixIncident)(std::span(levels_).first(count_), p, n, to_eye, light.data());
  return light;
}

}  // namespace brume
#endif
