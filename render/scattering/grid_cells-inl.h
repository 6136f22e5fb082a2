// The cells of a SourceGrid that points lie in, in SIMD. Included once per instruction set by the
// files that Highway compiles for each.

#if defined(BRUME_GRID_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_GRID_CELLS_INL_H
#undef BRUME_GRID_CELLS_INL_H
#else
#define BRUME_GRID_CELLS_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "render/grid/sweep_kernels.h"
#include "render/scattering/grid_levels.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int CornerBit(int corner, int axis) {
  return corner >> axis & 1;
}

// neighbour_index() of each corner of a cell, x fastest, for one of them; row after row.
constexpr std::array<std::uint32_t, 64> CornerNeighbours() {
  std::array<std::uint32_t, 64> neighbours{};
  for (int from = 0; from < 8; ++from) {
    for (int to = 0; to < 8; ++to) {
      const int link = neighbour_index(CornerBit(to, 0) - CornerBit(from, 0),
                                       CornerBit(to, 1) - CornerBit(from, 1),
                                       CornerBit(to, 2) - CornerBit(from, 2));
      neighbours[static_cast<std::size_t>(8 * from + to)] = static_cast<std::uint32_t>(link);
    }
  }
  return neighbours;
}
alignas(64) inline constexpr std::array<std::uint32_t, 64> corner_neighbours = CornerNeighbours();

// Drops the corners of a cell beside surfaces that one of them does not see: `seeing`, or the next
// that is in no solid. `node`: the first corner's index.
HWY_INLINE void HideCorners(const GridLevel& level, std::ptrdiff_t node, int seeing,
                            float (&corner_weights)[8]) {
  const auto blocked_at = [&](int corner) {
    const std::ptrdiff_t row = level.count.x;
    return level.occlusion_bits &
           level.blocked[node + CornerBit(corner, 0) +
                         (CornerBit(corner, 1) + CornerBit(corner, 2) * level.count.y) * row];
  };
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
  const hn::CappedTag<float, 8> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const std::uint32_t* neighbours = corner_neighbours.data() + 8 * seeing;
  auto all = hn::Zero(d);
  auto left = hn::Zero(d);
  for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
    const auto bits = hn::Shr(hn::Set(du, blocked), hn::LoadU(du, neighbours + i));
    const auto sees = hn::Eq(hn::And(bits, hn::Set(du, 1u)), hn::Zero(du));
    const auto weights = hn::LoadU(d, corner_weights + i);
    const auto seen = hn::IfThenElseZero(hn::RebindMask(d, sees), weights);
    hn::StoreU(seen, d, corner_weights + i);
    all = hn::Add(all, weights);
    left = hn::Add(left, seen);
  }
  const float sum = hn::GetLane(hn::SumOfLanes(d, all));
  const float sum_left = hn::GetLane(hn::SumOfLanes(d, left));
  if (!(sum_left > 0.0f)) {
    corner_weights[seeing] = sum;
    return;
  }
  const auto scale = hn::Set(d, sum / sum_left);
  for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
    hn::StoreU(hn::Mul(scale, hn::LoadU(d, corner_weights + i)), d, corner_weights + i);
  }
}

// Points whose cells are found at a time.
constexpr std::size_t max_points = 16;

using Points = hn::CappedTag<float, max_points>;

// The cells of the finest levels that hold points, clamped to the coarsest.
struct Cells {
  alignas(64) std::int32_t level[max_points];
  // Whether the point is beyond the coarsest of several levels.
  alignas(64) std::int32_t beyond[max_points];
  alignas(64) std::int32_t node[max_points];      // of the first corner
  alignas(64) std::int32_t first[3][max_points];  // the first corner along each axis
  alignas(64) float along[max_points];            // place in the cell along x
  // Times `weight`, of the edges along x from corners 0, 2, 4, 6.
  alignas(64) float edge_weights[4][max_points];

  // `coordinate(level, axis)`: of Lanes(Points()) points, in cells from node 0; `placed(axis)`: how
  // far in the same unit the places that are looked up are from there.
  template <class Coordinate, class Moved>
  HWY_INLINE Cells(std::span<const GridLevel> levels, const Coordinate& coordinate,
                   const Moved& moved, hn::Vec<Points> weight) {
    const Points d;
    const hn::RebindToSigned<Points> di;
    using V = hn::Vec<Points>;
    const GridLevel& coarsest = levels.back();
    const auto is_on = [&](const GridLevel& grid) HWY_ATTR {
      auto is_on_grid = hn::Eq(weight, weight);
      for (int k = 0; k < 3; ++k) {
        const V x = coordinate(grid, k);
        const V last = hn::Set(d, static_cast<float>(grid.count[k] - 1));
        is_on_grid = hn::And(is_on_grid, hn::And(hn::Ge(x, hn::Zero(d)), hn::Le(x, last)));
      }
      return is_on_grid;
    };
    auto on_any = hn::Eq(weight, weight);
    if (levels.size() > 1) on_any = is_on(coarsest);
    hn::Store(hn::IfThenElse(hn::RebindMask(di, on_any), hn::Zero(di), hn::Set(di, 1)), di, beyond);
    V place[3];
    V last[3];
    hn::Vec<decltype(di)> count[3];
    for (int k = 0; k < 3; ++k) {
      place[k] = coordinate(coarsest, k);
      last[k] = hn::Set(d, static_cast<float>(coarsest.count[k] - 2));
      count[k] = hn::Set(di, coarsest.count[k]);
    }
    auto finest = hn::Set(di, static_cast<std::int32_t>(levels.size() - 1));
    for (std::size_t l = levels.size() - 1; l-- > 0;) {
      const GridLevel& finer = levels[l];
      const auto on_finer = is_on(finer);
      for (int k = 0; k < 3; ++k) {
        const auto finer_last = hn::Set(d, static_cast<float>(finer.count[k] - 2));
        place[k] = hn::IfThenElse(on_finer, coordinate(finer, k), place[k]);
        last[k] = hn::IfThenElse(on_finer, finer_last, last[k]);
        count[k] =
            hn::IfThenElse(hn::RebindMask(di, on_finer), hn::Set(di, finer.count[k]), count[k]);
      }
      const auto finer_level = hn::Set(di, static_cast<std::int32_t>(l));
      finest = hn::IfThenElse(hn::RebindMask(di, on_finer), finer_level, finest);
    }
    auto index = hn::Zero(di);
    V f[3];
    for (int k = 3; k-- > 0;) {
      V x = moved(place[k], k);
      x = hn::Min(hn::Max(x, hn::Zero(d)), hn::Add(last[k], hn::Set(d, 1.0f)));
      const V low = hn::Min(hn::Floor(x), last[k]);
      f[k] = hn::Sub(x, low);
      const auto corner = hn::ConvertTo(di, low);
      hn::Store(corner, di, first[k]);
      index = hn::Add(hn::Mul(index, count[k]), corner);
    }
    hn::Store(index, di, node);
    hn::Store(f[0], d, along);
    hn::Store(finest, di, level);
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

  // The corner towards the eye, since the nearest to the point itself may be behind a wall; see
  // NodeVisibility.
  HWY_INLINE int EyeCorner(const GridLevel& grid, std::size_t i, float to_eye_x, float to_eye_y,
                           float to_eye_z) const {
    const bool is_towards[3] = {to_eye_x > 0.0f, to_eye_y > 0.0f, to_eye_z > 0.0f};
    int corner = 0;
    for (int k = 0; k < 3; ++k) {
      const bool is_high =
          first[k][i] == grid.eye_layers.cell[k] ? grid.eye_layers.is_high[k] != 0 : is_towards[k];
      corner |= is_high ? 1 << k : 0;
    }
    return corner;
  }

  HWY_INLINE void CornerWeights(std::size_t i, float (&corner_weights)[8]) const {
    for (std::size_t c = 0; c < 8; ++c) {
      const float share = (c & 1) != 0 ? along[i] : 1.0f - along[i];
      corner_weights[c] = share * edge_weights[c / 2][i];
    }
  }
};

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

// `sum` plus the weighted sum of `used` values of nodes of `size` at a cell's corners, in vectors
// of no more floats than nodes have.
template <std::size_t size, std::size_t used>
HWY_INLINE void AddNodes(const float* values, const GridLevel& level, std::int32_t node,
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

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
