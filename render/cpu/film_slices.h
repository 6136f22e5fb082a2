#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/cpu/film_airlight.h"
#include "render/cpu/sliced_airlight.h"
#include "render/optical_depth/ray_slices.h"

namespace brume {

// Slice boundaries for all rays of a film. They are chosen per tile; since the slicing error
// differs between tiles, boundaries that jump at tile borders would show as edges. So they vary
// continuously: nodes at the centers, sides and corners of tiles hold the merged boundaries of all
// adjacent tiles, and boundaries are interpolated between nodes.
class FilmSlices {
 public:
  // Chooses boundaries for all rays of the film's tiles; their range covers the medium along every
  // ray.
  void choose(const FilmTiles& film, const MediumIndex& medium, std::span<const SlicedLight> lights,
              int slices, const Job& job);

  // The nodes of a tile, valid until the next choose(). Thread-safe.
  [[nodiscard]] SliceNodes nodes(std::size_t tile) const;

 private:
  [[nodiscard]] std::span<const float> tile_boundaries(std::size_t tile) const {
    return std::span(chosen_).subspan(tile * stride_, counts_[tile]);
  }
  void merge(int column, int row);

  int columns_ = 0, rows_ = 0;  // of tiles
  std::size_t stride_ = 0;      // capacity per tile or node
  std::vector<float> chosen_;   // of tiles
  std::vector<std::size_t> counts_;
  std::vector<float> nodes_;  // 2 columns + 1 per row; padded by repeating the last boundary
  std::vector<std::size_t> node_counts_;
};

// Merges the boundaries of the tiles (at least one) around a node into as many as they have on
// average: sorts all boundaries and averages groups of them; the first and last are exact. Returns
// their number.
std::size_t merge_slices(std::span<const std::span<const float>> tiles, float* merged);

}  // namespace brume
