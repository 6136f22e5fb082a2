#pragma once

#include <glm/ext/vector_int2.hpp>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "render/settings.h"

namespace brume {

// The window that is rendered for a region of a film, so that its pixels have the bits that they
// have on the whole film: the region, and what its pixels look at. It begins where a tile of the
// whole film does, so lattices of samples, cells and blocks are the same, and ends with the whole
// film or so far from the region that it does not matter how.
//
// Distances are in tiles of airlight samples, since rays that are evaluated together share what is
// prepared for them. Samples of pixels look at pixels beside their tile. Where airlight is
// interpolated, cells look at pixels that the tiles beside evaluate; which these are depends on the
// tiles beside those, and how they are interpolated on the samples of the next ones. Slices are
// those of the tiles beside, too.
class FilmWindow {
 public:
  FilmWindow(const Film& film, const Settings& settings);

  // The same window for a part of its pixels alone, on its film.
  [[nodiscard]] FilmWindow around(const CameraRays::PixelRectangle& pixels) const;

  [[nodiscard]] const Film& film() const { return film_; }
  // The region's pixels on that film.
  [[nodiscard]] const CameraRays::PixelRectangle& region() const { return region_; }

  // How far from the region each stage goes [tiles]: it samples pixels; completes them but for
  // that; evaluates those that are not interpolated; interpolates; evaluates samples of airlight;
  // chooses slices.
  static constexpr int sampled = 0;
  [[nodiscard]] int complete() const { return sampled + (is_sampled_ ? 1 : 0); }
  [[nodiscard]] int exact() const { return complete() + (is_interpolated_ ? 1 : 0); }
  [[nodiscard]] int interpolated() const { return exact() + (is_interpolated_ ? 1 : 0); }
  [[nodiscard]] int evaluated() const { return interpolated() + (is_interpolated_ ? 1 : 0); }
  [[nodiscard]] int sliced() const { return evaluated() + 1; }

  // Whether a tile, by column and row, is so far away at most.
  [[nodiscard]] bool is_within(int tiles, const glm::ivec2& tile) const;
  // The pixels of complete() tiles, and those whose highlights they share, in whole blocks.
  [[nodiscard]] const CameraRays::PixelRectangle& shaded() const { return shaded_; }

  // The region of a frame of the window.
  [[nodiscard]] Frame cut(Frame frame) const;

 private:
  // Names the tiles of pixels of a film that begins with a tile.
  void set_tiles(const glm::ivec2& begin, const glm::ivec2& end);

  bool is_sampled_;
  bool is_interpolated_;
  glm::ivec2 tile_;  // its size [pixels]
  Film asked_;       // the region, or the whole film
  Film film_;
  CameraRays::PixelRectangle region_, shaded_;
  glm::ivec2 first_, end_;  // tiles with pixels of the region
};

}  // namespace brume
