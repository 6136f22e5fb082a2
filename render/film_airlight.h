#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "render/cpu/tile_rays.h"
#include "render/frame.h"
#include "render/job.h"
#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// What an airlight method does with the rays of one tile and the Gaussians that may matter to
// them. Returns the Gaussian x ray pairs it evaluated. Called from several threads.
using TileMethod = std::function<std::uint64_t(std::span<const std::uint32_t> gaussians,
                                               const TileRays& rays, const TileAirlight& out)>;

struct FilmAirlight {
  std::uint64_t pairs = 0;
  std::size_t gaussians_used = 0;  // that reach any ray
  std::size_t exact_pixels = 0;    // where the method itself was asked
};

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

// Fills frame.airlight, frame.transmittance and the pairs of pixels, tile by tile. All layers have
// their size, and the depth layer is there.
//
// With settings.airlight_scale 2 or 4 the method is asked at every so-many-th pixel of each row and
// column, and what lies between is upsampled from there to settings.upsampling_tolerance of the
// film's rms airlight, and of a transmittance of 1; pixels that upsample() cannot tell are asked
// too.
FilmAirlight film_airlight(const MediumIndex& medium, const CameraRays& rays,
                           const Settings& settings, const TileMethod& method, const RayEnds& ends,
                           const Job& job, Frame& frame);

}  // namespace brume
