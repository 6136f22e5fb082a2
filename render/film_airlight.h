#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "core/scene/scene.h"
#include "render/cpu/tile_rays.h"
#include "render/frame.h"
#include "render/job.h"
#include "render/medium_index.h"
#include "render/settings.h"
#include "render/tiles.h"

namespace brume {

// Where view rays end.
struct RayEnds {
  // Of rays that meet no surface [u].
  double open = std::numeric_limits<double>::infinity();
  // Per pixel, +inf where there is none [u]; empty: as the depth layer has them.
  std::span<const double> surfaces;

  [[nodiscard]] double of(const Frame& frame, std::size_t pixel) const {
    const double surface =
        surfaces.empty() ? static_cast<double>(frame.depth[pixel]) : surfaces[pixel];
    return std::isfinite(surface) ? surface : open;
  }
};

// The tiles of a film's samples, one sample for scale x scale pixels, and what their rays may meet.
struct FilmTiles {
  const Tiles& tiles;
  const Tiles::Lists& lists;
  const CameraRays& rays;
  const RayEnds& ends;
  const Frame& frame;
  int scale;

  // The pixels whose airlight a tile's samples tell.
  [[nodiscard]] CameraRays::PixelRectangle pixels(std::size_t tile) const;
  // The rays of these.
  [[nodiscard]] TileCone cone(std::size_t tile) const;
};

// An airlight method.
struct TileMethod {
  // Returns the Gaussian x ray pairs it evaluated for rays of one tile, which only these Gaussians
  // may matter to. Called from several threads.
  using Evaluate = std::function<std::uint64_t(std::span<const std::uint32_t> gaussians,
                                               const TileRays& rays, const TileAirlight& out)>;
  Evaluate evaluate;
  // Hears of all tiles of a film before any is evaluated. May be empty.
  std::function<void(const FilmTiles& film)> prepare;
};

struct FilmAirlight {
  std::uint64_t pairs = 0;
  std::size_t gaussians_used = 0;  // that reach any ray
  std::size_t exact_pixels = 0;    // where the method itself was asked
};

// Fills frame.airlight, frame.transmittance and the pairs of pixels, tile by tile. All layers have
// their size, and the depth layer is there.
//
// With settings.airlight_scale 2 or 4 the method is asked at every so-many-th pixel of each row and
// column, and what lies between is upsampled from there to settings.upsampling_tolerance of the
// film's rms airlight, and of a transmittance of 1; pixels that upsample() cannot tell and those
// nearest to `lights` are asked too.
FilmAirlight film_airlight(const MediumIndex& medium, std::span<const PointLight> lights,
                           const CameraRays& rays, const Settings& settings,
                           const TileMethod& method, const RayEnds& ends, const Job& job,
                           Frame& frame);

}  // namespace brume
