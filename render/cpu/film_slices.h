#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/cpu/ray_slices.h"
#include "render/cpu/sliced_airlight.h"
#include "render/film_airlight.h"

namespace brume {

// The slices of a film's rays. They are chosen for each tile, and change from tile to tile; slicing
// is off by another amount in each, so that where slices changed at once an edge would be seen.
// They change continuously instead: nodes stand in the middle of tiles, on their sides and at their
// corners, and have the slices of all tiles that they touch, merged; between nodes boundaries are
// interpolated one by one.
class FilmSlices {
 public:
  // For all rays that a film's tiles may ask for; the ends of slices hold all of the medium that
  // any ray of a tile may meet.
  void choose(const FilmTiles& film, const MediumIndex& medium, std::span<const SlicedLight> lights,
              int slices, const Job& job);

  // Of a tile of that film; valid until the next choose(). Thread-safe.
  [[nodiscard]] SliceNodes nodes(std::size_t tile) const;

 private:
  [[nodiscard]] std::span<const float> tile_boundaries(std::size_t tile) const {
    return std::span(chosen_).subspan(tile * stride_, counts_[tile]);
  }
  void merge(int column, int row);

  int columns_ = 0, rows_ = 0;  // of tiles
  std::size_t stride_ = 0;      // room for the boundaries of a tile or a node
  std::vector<float> chosen_;   // of tiles
  std::vector<std::size_t> counts_;
  std::vector<float> nodes_;  // 2 columns + 1 in a row; after the last boundary its repetitions
  std::vector<std::size_t> node_counts_;
};

// The slices of nodes that touch several tiles with as many boundaries as these have on average:
// all boundaries in order, each so many averaged, and the first and the last one. `tiles` are not
// empty. Returns how many they are.
std::size_t merge_slices(std::span<const std::span<const float>> tiles, float* merged);

}  // namespace brume
