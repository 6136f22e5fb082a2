#include "render/scattering/source_lookup.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/scattering/source_lookup.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/scattering/grid_cells-inl.h"
#include "render/simd/view_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// AddNodes<4, 4>() where no corner is hidden: both nodes of an edge at a time if vectors hold them.
HWY_INLINE void AddEdges(const float* values, const GridLevel& level, const Cells& cells,
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
template <class Rays, int bands, bool adds_clusters>
HWY_INLINE bool AddOf(std::span<const GridLevel> levels, const PathBatch& rays, const float* t,
                      const float* weights, const float* lobe_weights, std::size_t stride,
                      float* sums) {
  constexpr std::size_t size = SourceGrid::node_size(bands);
  constexpr std::size_t harmonics = 4 * sh_size(bands);
  bool sums_nodes = false;
  const Points d_rays;
  const std::size_t lanes = hn::Lanes(d_rays);
  for (std::size_t first = 0; first < rays.padded_size(); first += lanes) {
    const auto weight = hn::LoadU(d_rays, weights + first);
    if (hn::AllFalse(d_rays, hn::Gt(weight, hn::Zero(d_rays)))) continue;
    const auto distance = hn::LoadU(d_rays, t + first);
    const Rays some(d_rays, rays, first);
    const auto coordinate = [&](const GridLevel& level, int k) HWY_ATTR {
      const auto node = hn::Set(d_rays, level.first[k]);
      const auto along_axis = [k](const auto& v) HWY_ATTR {
        return k == 0 ? v.x : k == 1 ? v.y : v.z;
      };
      const auto first_node = along_axis(some.From({node, node, node}));
      const auto p = hn::Mul(distance, along_axis(some.w));
      return hn::Mul(hn::Set(d_rays, level.per_unit), hn::Sub(p, first_node));
    };
    const Cells cells(
        levels, coordinate, [](auto x, int) HWY_ATTR { return x; }, weight);
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::size_t ray = first + i;
      if (!(weights[ray] > 0.0f)) continue;
      const GridLevel& level = levels[static_cast<std::size_t>(cells.level[i])];
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
        HideCorners(level, cells.node[i],
                    cells.EyeCorner(level, i, -rays.x[ray], -rays.y[ray], -rays.z[ray]),
                    corner_weights);
      }
      float* const of_nodes = sum + (level.view ? 4 : 0);
      if (from_view) {
        AddNodes<4, 4>(level.view, level, cells.node[i], corner_weights, sum);
      } else {
        sums_nodes = true;
        AddNodes<size, harmonics>(level.values, level, cells.node[i], corner_weights, of_nodes);
      }
      if constexpr (adds_clusters) {
        sums_nodes = true;
        const float share = lobe_weights[ray] / weights[ray];
        for (float& corner : corner_weights) corner *= share;
        AddNodes<size, source_clusters>(level.values + harmonics, level, cells.node[i],
                                        corner_weights, of_nodes + harmonics);
      }
    }
  }
  return sums_nodes;
}

void ClusterTransmittanceAtOrigin(std::span<const GridLevel> levels,
                                  SourceLookup::ClusterTransmittance& passes) {
  const Points d;
  const auto coordinate = [&](const GridLevel& level, int k)
                              HWY_ATTR { return hn::Set(d, -level.per_unit * level.first[k]); };
  const Cells cells(
      levels, coordinate, [](auto x, int) HWY_ATTR { return x; }, hn::Set(d, 1.0f));
  passes.fill(0.0f);
  constexpr std::size_t size = SourceGrid::node_size(PhaseBands::max_bands);
  const GridLevel& level = levels[static_cast<std::size_t>(cells.level[0])];
  float corner_weights[8];
  cells.CornerWeights(0, corner_weights);
  AddNodes<size, source_clusters>(level.values + (size - source_clusters), level, cells.node[0],
                                  corner_weights, passes.data());
}

template <int bands, bool adds_clusters>
bool Add(std::span<const GridLevel> levels, const PathBatch& rays, const float* t,
         const float* weights, const float* lobe_weights, std::size_t stride, float* sums) {
  return WithRays(Points(), rays, [&]<class Rays>() HWY_ATTR {
    return AddOf<Rays, bands, adds_clusters>(levels, rays, t, weights, lobe_weights, stride, sums);
  });
}

bool AddSource(int bands, bool adds_clusters, std::span<const GridLevel> levels,
               const PathBatch& rays, const float* t, const float* weights,
               const float* lobe_weights, std::size_t stride, float* sums) {
  constexpr int max_bands = PhaseBands::max_bands;
  if (bands == 1) return Add<1, false>(levels, rays, t, weights, lobe_weights, stride, sums);
  if (!adds_clusters) {
    return Add<max_bands, false>(levels, rays, t, weights, lobe_weights, stride, sums);
  }
  return Add<max_bands, true>(levels, rays, t, weights, lobe_weights, stride, sums);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(AddSource);
HWY_EXPORT(ClusterTransmittanceAtOrigin);

SourceLookup::SourceLookup(const SourceGrid& grid, const glm::dvec3& origin, bool adds_clusters,
                           const NodeVisibility& visibility)
    : levels_(grid, origin, visibility),
      bands_(grid.bands()),
      adds_clusters_(adds_clusters && grid.bands() > 1) {}

bool SourceLookup::add(const PathBatch& rays, const float* t, const float* weights,
                       const float* lobe_weights, float* sums) const {
  return HWY_DYNAMIC_DISPATCH(AddSource)(bands_, adds_clusters_, levels_.all(), rays, t, weights,
                                         lobe_weights, sums_size(), sums);
}

void SourceLookup::set_view(std::span<const std::vector<float>> levels, bool is_parallel) {
  sums_nodes_ = false;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    GridLevel& level = levels_.all()[k];
    level.view = levels[k].data();
    if (is_parallel) {  // seen in one direction from everywhere
      level.view_begin = -std::numeric_limits<float>::infinity();
      sums_nodes_ |= levels_.size() > 1 || adds_clusters_;
      continue;
    }
    const float near = min_view_spacings / level.per_unit;
    const glm::vec3 last = level.first + glm::vec3(level.count - 1) / level.per_unit;
    const glm::vec3 nearest = glm::clamp(glm::vec3(0.0f), level.first, last);
    const bool has_near = glm::length(nearest) < near;
    level.view_begin = has_near ? near : 0.0f;
    sums_nodes_ |= has_near || levels_.size() > 1 || adds_clusters_;
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
    result += sums[f] * weights.at_nodes[f - harmonics];
  }
  return result;
}

SourceLookup::ClusterTransmittance SourceLookup::cluster_transmittance() const {
  ClusterTransmittance passes;
  const GridLevel& coarsest = levels_.all().back();
  const glm::vec3 cells = -coarsest.per_unit * coarsest.first;
  const glm::vec3 last(coarsest.count - 1);
  if (glm::clamp(cells, glm::vec3(0.0f), last) != cells) {
    passes.fill(1.0f);
    return passes;
  }
  HWY_DYNAMIC_DISPATCH(ClusterTransmittanceAtOrigin)(levels_.all(), passes);
  return passes;
}

}  // namespace brume
#endif
