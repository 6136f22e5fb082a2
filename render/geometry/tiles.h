#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/geometry/medium_index.h"

namespace brume {

// The film of airlight samples: every scale-th pixel, and the last of each row and column.
Film sample_film(const Film& film, int scale);

// The film divided into tiles, the unit of parallel rendering.
class Tiles {
 public:
  static constexpr int width = 16;
  static constexpr int height = 8;
  static constexpr int pixels = width * height;

  explicit Tiles(const Film& film);

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(columns_) * rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }

  // Calls visit(x, y) for the pixels of a rectangle of at most a tile, in blocks of 4 x 4, so that
  // vector lanes hold neighbours.
  template <class Visit>
  static void each_pixel(const CameraRays::PixelRectangle& r, Visit visit) {
    constexpr int block = 4;
    for (int y0 = r.y0; y0 < r.y1; y0 += block) {
      for (int x0 = r.x0; x0 < r.x1; x0 += block) {
        for (int y = y0; y < std::min(y0 + block, r.y1); ++y) {
          for (int x = x0; x < std::min(x0 + block, r.x1); ++x) visit(x, y);
        }
      }
    }
  }

  // The pixels [x0, x1) x [y0, y1) of a tile, clipped to the film.
  [[nodiscard]] CameraRays::PixelRectangle rectangle(std::size_t tile) const;

  // Tile binning: for every tile the indices of the Gaussians whose cutoff sphere its rays may
  // enter, ascending. `rays` sees `scale` pixels for one of the film's, and gaps between tiles
  // belong to the tile before. A region's film begins at a tile of the whole one. Linear in
  // Gaussians and entries; with more than `max_entries` entries on the whole film all tiles share
  // one list.
  struct Lists {
    std::vector<std::size_t> offsets;  // count() + 1; empty: one shared list
    std::vector<std::uint32_t> gaussians;
    std::size_t used = 0;  // Gaussians in any list

    [[nodiscard]] std::span<const std::uint32_t> gaussians_of(std::size_t tile) const {
      if (offsets.empty()) return gaussians;
      return std::span(gaussians).subspan(offsets[tile], offsets[tile + 1] - offsets[tile]);
    }
  };
  static constexpr std::size_t max_entries = 100'000'000;
  [[nodiscard]] Lists lists(const MediumIndex& medium, const CameraRays& rays, int scale = 1,
                            std::size_t entry_limit = max_entries) const;

 private:
  Film film_;
  int columns_;
  int rows_;
};

}  // namespace brume
