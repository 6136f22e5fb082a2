#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/camera.h"
#include "render/medium_index.h"

namespace brume {

// The film in tiles, each rendered by one thread in one go.
class Tiles {
 public:
  static constexpr int width = 16;
  static constexpr int height = 8;
  static constexpr int pixels = width * height;

  explicit Tiles(const Film& film);

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(columns_) * rows_; }

  // The pixels [x0, x1) x [y0, y1) of a tile; those at the right and lower border are cut.
  [[nodiscard]] CameraRays::PixelRectangle rectangle(std::size_t tile) const;

  // For every tile the Gaussians whose reach the rays of its pixels may enter, in ascending
  // order, as one array with offsets. Time is linear in Gaussians and entries; where there would be
  // more than `most_entries` (very many Gaussians that fill the view), all tiles share one list.
  struct Lists {
    std::vector<std::size_t> offsets;  // count() + 1; empty: one list for all tiles
    std::vector<std::uint32_t> gaussians;
    std::size_t used = 0;  // Gaussians in any list

    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t tile) const {
      if (offsets.empty()) return gaussians;
      return std::span(gaussians).subspan(offsets[tile], offsets[tile + 1] - offsets[tile]);
    }
  };
  static constexpr std::size_t most_entries = 100'000'000;
  [[nodiscard]] Lists lists(const MediumIndex& medium, const CameraRays& rays,
                            std::size_t most = most_entries) const;

 private:
  Film film_;
  int columns_;
  int rows_;
};

}  // namespace brume
