// How light is swept through the nodes of a grid, slab by slab. Included once per instruction set
// by the files that Highway compiles for each.

#if defined(BRUME_SWEEP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_SWEEP_INL_H
#undef BRUME_SWEEP_INL_H
#else
#define BRUME_SWEEP_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "render/grid/sweep_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;

// The values of a slab of nodes with a border of two nodes, and padding to full vectors at the end
// of rows.
struct Slab {
  std::size_t columns, stride;
  float border;
  std::vector<float> values;

  Slab(std::size_t width, std::size_t height, float outside)
      : columns(width),
        stride(width + 4 + hn::Lanes(D())),
        border(outside),
        values(stride * (height + 4), outside) {}

  float* row(std::size_t v) { return values.data() + (v + 2) * stride + 2; }
  // After full vectors were written over the border.
  void end_row(std::size_t v) { std::fill_n(row(v) + columns, stride - columns - 2, border); }
};

// A slab and the one before it.
struct TwoSlabs {
  Slab before, now;

  TwoSlabs(std::size_t columns, std::size_t rows, float border)
      : before(columns, rows, border), now(before) {}
  void advance() { std::swap(before, now); }
};

// Where the grid's values lie along the axes of a sweep: u and v in a slab, s from slab to slab.
struct Axes {
  int u, v, s;
  std::ptrdiff_t step_u, step_v, step_s;

  Axes(const glm::ivec3& count, const glm::vec3& w) {
    const glm::vec3 size = glm::abs(w);
    s = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    u = s == 0 ? 1 : 0;
    v = s == 2 ? 1 : 2;
    const std::ptrdiff_t step[] = {1, count.x, std::ptrdiff_t{count.x} * count.y};
    step_u = step[u];
    step_v = step[v];
    step_s = step[s];
  }
};

// What all sweeps share: the order of the slabs, and where rows of them lie in the grid.
struct Sweep {
  Axes axes;
  std::size_t columns, rows, slabs;
  std::ptrdiff_t first, step;  // of slabs
  float length;                // of the way between slabs [u]
  float shift_u, shift_v;

  Sweep(const GridNodes& nodes, const glm::vec3& w)
      : axes(nodes.count, w),
        columns(static_cast<std::size_t>(nodes.count[axes.u])),
        rows(static_cast<std::size_t>(nodes.count[axes.v])),
        slabs(static_cast<std::size_t>(nodes.count[axes.s])) {
    const float steep = std::abs(w[axes.s]);
    const bool backwards = w[axes.s] > 0.0f;
    first = backwards ? static_cast<std::ptrdiff_t>(slabs - 1) * axes.step_s : 0;
    step = backwards ? -axes.step_s : axes.step_s;
    length = nodes.spacing / steep;
    shift_u = w[axes.u] / steep;
    shift_v = w[axes.v] / steep;
  }
  [[nodiscard]] std::ptrdiff_t row(std::size_t slab, std::size_t v) const {
    return first + static_cast<std::ptrdiff_t>(slab) * step +
           static_cast<std::ptrdiff_t>(v) * axes.step_v;
  }
  void read(const float* input, float* target) const {
    for (std::size_t u = 0; u < columns; ++u) {
      target[u] = input[static_cast<std::ptrdiff_t>(u) * axes.step_u];
    }
  }
  void write(const float* input, float* target) const {
    for (std::size_t u = 0; u < columns; ++u) {
      target[static_cast<std::ptrdiff_t>(u) * axes.step_u] = input[u];
    }
  }
};

// The nodes of the slab before that light along a sweep passes between on its way to a node, with
// the weights of a linear interpolation.
struct Upwind {
  int u = 0, v = 0;  // offsets
  float weight = 0.0f;
  int neighbour = 0;

  [[nodiscard]] bool is_hidden_from(const OccludedNode& node) const {
    return (node.blocked >> neighbour & 1u) != 0;
  }
};

inline std::array<Upwind, 4> UpwindNodes(const Sweep& sweep, const glm::vec3& w) {
  const int low_u = sweep.shift_u < 0.0f ? -1 : 0;
  const int low_v = sweep.shift_v < 0.0f ? -1 : 0;
  const float f_u = sweep.shift_u - static_cast<float>(low_u);
  const float f_v = sweep.shift_v - static_cast<float>(low_v);
  std::array<Upwind, 4> upwind;
  for (int i = 0; i < 4; ++i) {
    Upwind& node = upwind[static_cast<std::size_t>(i)];
    node.u = low_u + (i & 1);
    node.v = low_v + (i >> 1);
    node.weight = ((i & 1) != 0 ? f_u : 1.0f - f_u) * ((i >> 1) != 0 ? f_v : 1.0f - f_v);
    glm::ivec3 offset(0);
    offset[sweep.axes.u] = node.u;
    offset[sweep.axes.v] = node.v;
    offset[sweep.axes.s] = w[sweep.axes.s] > 0.0f ? 1 : -1;
    node.neighbour = neighbour_index(offset.x, offset.y, offset.z);
  }
  return upwind;
}

// Index of a hidden neighbour's link.
inline std::size_t LinkOf(const OccludedNode& node, int neighbour) {
  const std::uint32_t before = node.blocked & ((1u << neighbour) - 1u);
  return node.first + static_cast<std::size_t>(std::popcount(before));
}

// The share of a hidden neighbour's light that panes let through.
inline float PassingOf(const SweepOcclusion& occlusion, std::size_t link) {
  return occlusion.passing.empty() ? 0.0f : occlusion.passing[link];
}

// What a node sees of the slab before. The rest of the weights is the surfaces': so on average they
// end where they do, wherever between the nodes that is. Weighing only what is seen, slanting light
// would go on along walls.
struct Seen {
  float sum = 0.0f;
  float weight = 0.0f;
  float least = std::numeric_limits<float>::infinity();  // of values that count
  float most = 0.0f;

  bool through_panes = false;

  Seen(const SweepOcclusion& occlusion, std::span<const Upwind> upwind, const OccludedNode& node,
       Slab& slab, std::size_t u, std::size_t v) {
    for (const Upwind& other : upwind) {
      float share = other.weight;
      if (other.is_hidden_from(node)) {
        const float passing = PassingOf(occlusion, LinkOf(node, other.neighbour));
        if (!(passing > 0.0f)) continue;
        share *= passing;
        through_panes = true;
      }
      const auto row = static_cast<std::ptrdiff_t>(v) + other.v;
      const float* values = slab.row(0) + row * static_cast<std::ptrdiff_t>(slab.stride);
      const float value = values[static_cast<std::ptrdiff_t>(u) + other.u];
      sum += share * value;
      weight += share;
      if (!(other.weight > min_weight)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  [[nodiscard]] float mean() const { return weight > 0.0f ? sum / weight : 0.0f; }
  // Whether a shadow's edge may be here: some of it is lit, and some hidden or below this share of
  // the most.
  [[nodiscard]] bool is_penumbra(float lit_share) const {
    constexpr float darkest = 0.01f;
    return most > darkest && !through_panes &&
           (weight < 1.0f - min_weight || least < lit_share * most);
  }
  // The light of those that are lit.
  [[nodiscard]] float lit(float lit_share) const {
    return least < lit_share * most ? most : mean();
  }

 private:
  static constexpr float min_weight = 0.01f;
};

// Calls fix(u, node) for the nodes of a row that surfaces hide neighbours from.
template <class Fix>
void each_occluded(const SweepOcclusion& occlusion, const Sweep& sweep, std::ptrdiff_t row,
                   Fix fix) {
  if (occlusion.empty()) return;
  for (std::size_t u = 0; u < sweep.columns; ++u) {
    const std::ptrdiff_t i = row + static_cast<std::ptrdiff_t>(u) * sweep.axes.step_u;
    const std::int32_t index = occlusion.index[static_cast<std::size_t>(i)];
    if (index >= 0) fix(u, occlusion.nodes[static_cast<std::size_t>(index)]);
  }
}

// Where light enters the grid in a row of nodes.
struct Entry {
  bool whole_row, first, last;

  Entry(const Sweep& sweep, std::size_t slab, std::size_t v)
      : whole_row(slab == 0 || (sweep.shift_v < 0.0f && v == 0) ||
                  (sweep.shift_v > 0.0f && v + 1 == sweep.rows)),
        first(sweep.shift_u < 0.0f),
        last(sweep.shift_u > 0.0f) {}
  [[nodiscard]] bool holds(std::size_t u, std::size_t columns) const {
    return whole_row || (first && u == 0) || (last && u + 1 == columns);
  }
};

// Replaces the light of nodes of a row where it enters the grid by at(u).
template <class At>
void let_in(const Entry& entry, std::size_t columns, float* row, At at) {
  for (std::size_t u = 0; entry.whole_row && u < columns; ++u) row[u] = at(u);
  if (entry.first) row[0] = at(0);
  if (entry.last) row[columns - 1] = at(columns - 1);
}

// Continues a slab beyond its ends.
inline void extend(const Sweep& sweep, Slab& slab) {
  const auto rows = static_cast<std::ptrdiff_t>(sweep.rows);
  const auto columns = static_cast<std::ptrdiff_t>(sweep.columns);
  const auto stride = static_cast<std::ptrdiff_t>(slab.stride);
  float* const first = slab.row(0);
  for (std::ptrdiff_t v = 0; v < rows; ++v) {
    float* row = first + v * stride;
    row[-2] = row[-1] = row[0];
    row[columns] = row[columns + 1] = row[columns - 1];
  }
  for (const std::ptrdiff_t v : {-2, -1}) {
    std::copy_n(first - 2, columns + 4, first - 2 + v * stride);
    std::copy_n(first - 2 + (rows - 1) * stride, columns + 4, first - 2 + (rows - 1 - v) * stride);
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
