#include "render/cpu/film_slices.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "render/geometry/ray_range.h"
#include "render/slices/slice_boundaries.h"

namespace brume {

std::size_t merge_slices(std::span<const std::span<const float>> tiles, float* merged) {
  if (tiles.size() == 1) {
    std::ranges::copy(tiles[0], merged);
    return tiles[0].size();
  }
  thread_local std::vector<float> all, more;
  all.assign(tiles[0].begin(), tiles[0].end());
  for (const std::span<const float> tile : tiles.subspan(1)) {
    more.resize(all.size() + tile.size());
    std::ranges::merge(all, tile, more.begin());
    std::swap(all, more);
  }
  std::size_t count = 0;
  for (std::size_t first = 0; first < all.size(); first += tiles.size()) {
    const auto each = std::span(all).subspan(first, std::min(tiles.size(), all.size() - first));
    merged[count++] =
        std::accumulate(each.begin(), each.end(), 0.0f) / static_cast<float>(each.size());
  }
  merged[0] = all.front();
  merged[count - 1] = all.back();
  return count;
}

void FilmSlices::choose(const FilmTiles& film, const MediumIndex& medium,
                        std::span<const SlicedLight> lights, int slices, const Job& job) {
  columns_ = film.tiles.columns();
  rows_ = film.tiles.rows();
  const std::size_t tiles = film.tiles.count();
  stride_ = max_boundaries(slices, lights.size(), medium.homogeneous_density() > 0.0);
  chosen_.resize(tiles * stride_);
  counts_.assign(tiles, 0);
  job.parallel_for(tiles, [&](std::size_t tile) {
    if (!film.is_within(film.window.sliced(), tile)) return;
    thread_local std::vector<double> boundaries;
    choose_slices(medium, film.lists.gaussians_of(tile), lights, film.cone(tile), slices,
                  boundaries);
    counts_[tile] = boundaries.size() < 2 ? 0 : boundaries.size();
    std::ranges::transform(std::span(boundaries).first(counts_[tile]),
                           chosen_.begin() + tile * stride_,
                           [](double t) { return static_cast<float>(std::min(t, endless)); });
  });
  const auto node_columns = static_cast<std::size_t>(2 * columns_ + 1);
  const std::size_t nodes = node_columns * static_cast<std::size_t>(2 * rows_ + 1);
  nodes_.resize(nodes * stride_);
  node_counts_.assign(nodes, 0);
  job.parallel_for(static_cast<std::size_t>(2 * rows_ + 1), [&](std::size_t row) {
    for (int column = 0; column <= 2 * columns_; ++column) merge(column, static_cast<int>(row));
  });
}

// Fills a node from the tiles that it touches.
void FilmSlices::merge(int column, int row) {
  std::array<std::span<const float>, 4> tiles;
  std::size_t count = 0;
  for (int y = (row - 1) / 2; y <= std::min(row / 2, rows_ - 1); ++y) {
    for (int x = (column - 1) / 2; x <= std::min(column / 2, columns_ - 1); ++x) {
      const auto boundaries = tile_boundaries(static_cast<std::size_t>(y * columns_ + x));
      if (!boundaries.empty()) tiles[count++] = boundaries;
    }
  }
  if (count == 0) return;
  const auto node = static_cast<std::size_t>(row * (2 * columns_ + 1) + column);
  float* const boundaries = nodes_.data() + node * stride_;
  node_counts_[node] = merge_slices(std::span(tiles).first(count), boundaries);
  std::fill(boundaries + node_counts_[node], boundaries + stride_,
            boundaries[node_counts_[node] - 1]);
}

SliceNodes FilmSlices::nodes(std::size_t tile) const {
  SliceNodes nodes;
  if (counts_[tile] == 0) return nodes;
  const std::size_t column = tile % static_cast<std::size_t>(columns_);
  const std::size_t row = tile / static_cast<std::size_t>(columns_);
  for (std::size_t k = 0; k < nodes.boundaries.size(); ++k) {
    const std::size_t node =
        (2 * row + k / 3) * static_cast<std::size_t>(2 * columns_ + 1) + 2 * column + k % 3;
    nodes.boundaries[k] = nodes_.data() + node * stride_;
    nodes.count = std::max(nodes.count, node_counts_[node]);
  }
  return nodes;
}

}  // namespace brume
