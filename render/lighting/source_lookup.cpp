#include "render/lighting/source_lookup.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/lighting/source_lookup.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Drops the corners of a cell beside surfaces that one of them does not see: the one towards the
// eye, since the nearest to the point itself may be behind a wall; or the next that is in no solid.
// `node`: the first corner's index.
void HideCorners(const SourceLookup::Level& level, std::ptrdiff_t node, const glm::vec3& to_eye,
                 float (&corner_weights)[8]) {
  const auto bit = [](int corner, int k) { return corner >> k & 1; };
  const auto blocked_at = [&](int corner) {
    const std::ptrdiff_t row = level.count.x;
    return level.occlusion_bits &
           level.blocked[node + bit(corner, 0) +
                         (bit(corner, 1) + bit(corner, 2) * level.count.y) * row];
  };
  int seeing = 0;
  for (int k = 0; k < 3; ++k) seeing |= (to_eye[k] > 0.0f ? 1 : 0) << k;
  std::uint32_t blocked = blocked_at(seeing);
  if (blocked == 0) return;
  if ((blocked & GridOcclusion::enclosed_bit) != 0) {
    for (const int flips : {1, 2, 4, 3, 5, 6, 7}) {
      if ((blocked_at(seeing ^ flips) & GridOcclusion::enclosed_bit) != 0) continue;
      seeing ^= flips;
      blocked = blocked_at(seeing);
      break;
    }
  }
  float all = 0.0f;
  float left = 0.0f;
  for (int i = 0; i < 8; ++i) {
    all += corner_weights[i];
    const int link = neighbour_index(bit(i, 0) - bit(seeing, 0), bit(i, 1) - bit(seeing, 1),
                                     bit(i, 2) - bit(seeing, 2));
    if ((blocked >> link & 1u) != 0) corner_weights[i] = 0.0f;
    left += corner_weights[i];
  }
  if (left > 0.0f) {
    for (float& weight : corner_weights) weight *= all / left;
  } else {
    corner_weights[seeing] = all;
  }
}

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
    for (int k = 0; k < 3; ++k) {
      const auto last = static_cast<float>(level.count[k] - 2);
      const float x = std::min(std::max(coordinate[k], 0.0f), last + 1.0f);
      const float low = std::min(static_cast<float>(static_cast<int>(x)), last);
      corner += static_cast<std::ptrdiff_t>(low) * step[k];
      f[k] = x - low;
    }
    for (int i = 0; i < 8; ++i) {
      corner_weights[i] = ((i & 1) != 0 ? f[0] : 1.0f - f[0]) *
                          ((i & 2) != 0 ? f[1] : 1.0f - f[1]) * ((i & 4) != 0 ? f[2] : 1.0f - f[2]);
    }
    if (!level.blocked || to_eye == glm::vec3(0.0f)) return;
    HideCorners(level, (corner - values) / size, to_eye, corner_weights);
  }

  // The nearest node to a point at this distance from a plane is on the same side [cells].
  static float Reach(const glm::vec3& normal) {
    return 0.5f * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
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

// `value` plus the weighted sum of what the nodes of `size` floats at a cell's corners hold; the
// first corner's at `corner`.
template <std::size_t size, class D>
HWY_INLINE hn::Vec<D> AddCorners(D d, const float* corner, std::ptrdiff_t row, std::ptrdiff_t slab,
                                 const float (&corner_weights)[8], hn::Vec<D> value) {
  constexpr auto step = static_cast<std::ptrdiff_t>(size);
  for (int c = 0; c < 8; ++c) {
    const float* at = corner + (c & 1) * step + (c >> 1 & 1) * row + (c >> 2) * slab;
    value = hn::MulAdd(hn::Set(d, corner_weights[c]), hn::LoadU(d, at), value);
  }
  return value;
}

// What a cell has at its point, from float i of its nodes on.
template <std::size_t size, class D>
HWY_INLINE hn::Vec<D> Mixed(const Cell& cell, D d, std::size_t i) {
  return AddCorners<size>(d, cell.corner + i, cell.row, cell.slab, cell.corner_weights,
                          hn::Zero(d));
}

// Rays whose cells are found at a time.
constexpr std::size_t max_rays = 16;

using Rays = hn::CappedTag<float, max_rays>;

// The cells of points on several rays.
struct Cells {
  alignas(64) std::int32_t level[max_rays];
  alignas(
      64) std::int32_t beyond[max_rays];    // whether the point is beyond the coarser of two levels
  alignas(64) std::int32_t node[max_rays];  // of the first corner
  alignas(64) float along[max_rays];        // place in the cell along x
  // Times `weight`, of the edges along x from corners 0, 2, 4, 6.
  alignas(64) float edge_weights[4][max_rays];

  // Those of `Lanes(Rays())` points, from ray `first` on.
  HWY_INLINE Cells(std::span<const SourceLookup::Level> levels, const PathBatch& rays,
                   std::size_t first, hn::Vec<Rays> t, hn::Vec<Rays> weight) {
    const Rays d;
    const hn::RebindToSigned<Rays> di;
    using V = hn::Vec<Rays>;
    const float* directions[] = {rays.x.data(), rays.y.data(), rays.z.data()};
    const SourceLookup::Level& coarsest = levels.back();
    const auto coordinate = [&](const SourceLookup::Level& grid, int k) HWY_ATTR {
      const V p = hn::Mul(t, hn::LoadU(d, directions[k] + first));
      return hn::Mul(hn::Set(d, grid.per_unit), hn::Sub(p, hn::Set(d, grid.first[k])));
    };
    const auto is_on = [&](const SourceLookup::Level& grid) HWY_ATTR {
      auto is_on_grid = hn::Eq(t, t);
      for (int k = 0; k < 3; ++k) {
        const V x = coordinate(grid, k);
        const V last = hn::Set(d, static_cast<float>(grid.count[k] - 1));
        is_on_grid = hn::And(is_on_grid, hn::And(hn::Ge(x, hn::Zero(d)), hn::Le(x, last)));
      }
      return is_on_grid;
    };
    auto on_finest = hn::Eq(t, t);
    auto on_any = on_finest;
    if (levels.size() > 1) {
      on_finest = is_on(levels[0]);
      on_any = is_on(coarsest);
    }
    hn::Store(hn::IfThenElse(hn::RebindMask(di, on_any), hn::Zero(di), hn::Set(di, 1)), di, beyond);
    auto index = hn::Zero(di);
    V f[3];
    for (int k = 3; k-- > 0;) {
      V x = coordinate(levels[0], k);
      V last = hn::Set(d, static_cast<float>(levels[0].count[k] - 2));
      auto count = hn::Set(di, levels[0].count[k]);
      if (levels.size() > 1) {
        x = hn::IfThenElse(on_finest, x, coordinate(coarsest, k));
        last =
            hn::IfThenElse(on_finest, last, hn::Set(d, static_cast<float>(coarsest.count[k] - 2)));
        count =
            hn::IfThenElse(hn::RebindMask(di, on_finest), count, hn::Set(di, coarsest.count[k]));
      }
      x = hn::Min(hn::Max(x, hn::Zero(d)), hn::Add(last, hn::Set(d, 1.0f)));
      const V low = hn::Min(hn::Floor(x), last);
      f[k] = hn::Sub(x, low);
      index = hn::Add(hn::Mul(index, count), hn::ConvertTo(di, low));
    }
    hn::Store(index, di, node);
    hn::Store(f[0], d, along);
    const auto other = hn::Set(di, static_cast<std::int32_t>(levels.size() - 1));
    hn::Store(hn::IfThenElse(hn::RebindMask(di, on_finest), hn::Zero(di), other), di, level);
    const auto split = [&](V whole, V fraction, V(&parts)[2]) HWY_ATTR {
      parts[1] = hn::Mul(whole, fraction);
      parts[0] = hn::Sub(whole, parts[1]);
    };
    V z[2];
    split(weight, f[2], z);
    for (int k = 0; k < 2; ++k) {
      V y[2];
      split(z[k], f[1], y);
      for (int j = 0; j < 2; ++j) hn::Store(y[j], d, edge_weights[2 * k + j]);
    }
  }

  void CornerWeights(std::size_t i, float (&corner_weights)[8]) const {
    for (int c = 0; c < 8; ++c) {
      const float share = (c & 1) != 0 ? along[i] : 1.0f - along[i];
      corner_weights[c] = share * edge_weights[c / 2][i];
    }
  }
};

// `sum` plus the weighted sum of `used` values of nodes of `size` at a cell's corners, in vectors
// of no more floats than nodes have.
template <std::size_t size, std::size_t used>
HWY_INLINE void AddNodes(const float* values, const SourceLookup::Level& level, std::int32_t node,
                         const float (&corner_weights)[8], float* sum) {
  const hn::CappedTag<float, (size < 16 ? size : 16)> d;
  constexpr auto step = static_cast<std::ptrdiff_t>(size);
  const std::ptrdiff_t row = step * level.count.x;
  const std::ptrdiff_t slab = row * level.count.y;
  const float* corner = values + step * node;
  for (std::size_t k = 0; k < used; k += hn::Lanes(d)) {
    const auto value = hn::LoadU(d, sum + k);
    hn::StoreU(AddCorners<size>(d, corner + k, row, slab, corner_weights, value), d, sum + k);
  }
}

// AddNodes<4, 4>() where no corner is hidden: both nodes of an edge at a time if vectors hold them.
HWY_INLINE void AddEdges(const float* values, const SourceLookup::Level& level, const Cells& cells,
                         std::size_t i, float* sum) {
#if HWY_MAX_BYTES >= 32
  const hn::CappedTag<float, 8> d;
  const hn::Half<hn::CappedTag<float, 8>> node;
  const std::ptrdiff_t row = 4 * level.count.x;
  const std::ptrdiff_t slab = row * level.count.y;
  const float* corner = values + 4 * cells.node[i];
  const auto edge = [&](std::size_t e, std::ptrdiff_t step) HWY_ATTR {
    return hn::Mul(hn::Set(d, cells.edge_weights[e][i]), hn::LoadU(d, corner + step));
  };
  const auto edges =
      hn::Add(hn::Add(edge(0, 0), edge(1, row)), hn::Add(edge(2, slab), edge(3, slab + row)));
  const auto begin = hn::LowerHalf(edges);
  const auto along = hn::Sub(hn::UpperHalf(node, edges), begin);
  const auto value = hn::MulAdd(hn::Set(node, cells.along[i]), along, begin);
  hn::StoreU(hn::Add(hn::LoadU(node, sum), value), node, sum);
#else
  float corner_weights[8];
  cells.CornerWeights(i, corner_weights);
  AddNodes<4, 4>(values, level, cells.node[i], corner_weights, sum);
#endif
}

// `stride`: floats per ray in `sums`.
template <int bands, bool adds_clusters>
HWY_INLINE bool Add(std::span<const SourceLookup::Level> levels, const PathBatch& rays,
                    const float* t, const float* weights, std::size_t stride, float* sums) {
  constexpr std::size_t size = SourceGrid::node_size(bands);
  constexpr std::size_t used = adds_clusters ? size : 4 * sh_size(bands);
  bool sums_nodes = false;
  const Rays d_rays;
  const std::size_t lanes = hn::Lanes(d_rays);
  for (std::size_t first = 0; first < rays.padded_size(); first += lanes) {
    const auto weight = hn::LoadU(d_rays, weights + first);
    if (hn::AllFalse(d_rays, hn::Gt(weight, hn::Zero(d_rays)))) continue;
    const Cells cells(levels, rays, first, hn::LoadU(d_rays, t + first), weight);
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::size_t ray = first + i;
      if (!(weights[ray] > 0.0f)) continue;
      const SourceLookup::Level& level = levels[static_cast<std::size_t>(cells.level[i])];
      float* sum = sums + ray * stride;
      const bool from_view = level.view && t[ray] >= level.view_begin && cells.beyond[i] == 0;
      if (!level.blocked && (bands == 1 || (from_view && !adds_clusters))) {
        sums_nodes |= !from_view;
        AddEdges(from_view ? level.view : level.values, level, cells, i, sum);
        continue;
      }
      float corner_weights[8];
      cells.CornerWeights(i, corner_weights);
      if (level.blocked) {
        HideCorners(level, cells.node[i], -glm::vec3(rays.x[ray], rays.y[ray], rays.z[ray]),
                    corner_weights);
      }
      if (from_view) {
        AddNodes<4, 4>(level.view, level, cells.node[i], corner_weights, sum);
        if constexpr (adds_clusters) {
          constexpr std::size_t clusters = 4 * sh_size(bands);
          sums_nodes = true;
          AddNodes<size, source_clusters>(level.values + clusters, level, cells.node[i],
                                          corner_weights, sum + 4 + clusters);
        }
      } else {
        sums_nodes = true;
        float* of_nodes = sum + (level.view ? 4 : 0);
        AddNodes<size, used>(level.values, level, cells.node[i], corner_weights, of_nodes);
      }
    }
  }
  return sums_nodes;
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

bool AddSource(int bands, bool adds_clusters, std::span<const SourceLookup::Level> levels,
               const PathBatch& rays, const float* t, const float* weights, std::size_t stride,
               float* sums) {
  constexpr int max_bands = PhaseBands::max_bands;
  if (bands == 1) return Add<1, false>(levels, rays, t, weights, stride, sums);
  if (!adds_clusters) return Add<max_bands, false>(levels, rays, t, weights, stride, sums);
  return Add<max_bands, true>(levels, rays, t, weights, stride, sums);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(AddSource);
HWY_EXPORT(ClusterTransmittanceAtOrigin);
HWY_EXPORT(MixIncident);

SourceLookup::SourceLookup(const SourceGrid& grid, const glm::dvec3& origin, bool adds_clusters,
                           std::uint32_t occlusion_bits)
    : bands_(grid.bands()), adds_clusters_(adds_clusters && grid.bands() > 1) {
  for (const SourceGrid::Level& level : grid.levels()) {
    levels_[count_++] = {glm::vec3(level.first - origin),
                         1.0f / level.nodes.spacing,
                         level.nodes.count,
                         level.values.data(),
                         level.incident.data(),
                         level.surfaces && !level.surfaces->blocked().empty()
                             ? level.surfaces->blocked().data()
                             : nullptr,
                         occlusion_bits};
  }
}

bool SourceLookup::add(const PathBatch& rays, const float* t, const float* weights,
                       float* sums) const {
  return HWY_DYNAMIC_DISPATCH(AddSource)(bands_, adds_clusters_, std::span(levels_).first(count_),
                                         rays, t, weights, sums_size(), sums);
}

void SourceLookup::set_view(const std::array<std::vector<float>, 2>& levels) {
  sums_nodes_ = false;
  for (std::size_t k = 0; k < count_; ++k) {
    Level& level = levels_[k];
    level.view = levels[k].data();
    const float near = min_view_spacings / level.per_unit;
    const glm::vec3 last = level.first + glm::vec3(level.count - 1) / level.per_unit;
    const glm::vec3 nearest = glm::clamp(glm::vec3(0.0f), level.first, last);
    const bool has_near = glm::length(nearest) < near;
    level.view_begin = has_near ? near : 0.0f;
    sums_nodes_ |= has_near || count_ > 1 || adds_clusters_;
  }
}

glm::vec3 SourceLookup::source(std::span<const float> sums, const SourceWeights& weights) const {
  const std::size_t harmonics = 4 * sh_size(bands_);
  glm::vec3 result(0.0f);
  if (view_size() > 0) {
    result = {sums[0], sums[1], sums[2]};
    if (!sums_nodes_) return result;
    sums = sums.subspan(view_size());
  }
  for (std::size_t i = 0; i < harmonics; i += 4) {
    const float* weight = weights.harmonics.data() + i;
    result += glm::vec3(weight[0] * sums[i], weight[1] * sums[i + 1], weight[2] * sums[i + 2]);
  }
  if (!adds_clusters_) return result;
  for (std::size_t f = harmonics; f < sums.size(); ++f) {
    result += sums[f] * weights.narrow[f - harmonics];
  }
  return result;
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
