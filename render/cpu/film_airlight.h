#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "brume/frame.h"
#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/tile_rays.h"
#include "render/geometry/tiles.h"
#include "render/prepare/film_window.h"
#include "render/prepare/ray_ends.h"
#include "render/settings.h"
#include "render/shading/mirrored_light.h"
#include "render/util/job.h"

namespace brume {

// The tiles of a film's airlight samples, one sample per scale x scale pixels.
struct FilmTiles {
  const Tiles& tiles;
  const Tiles::Lists& lists;
  const CameraRays& rays;
  const RayEnds& ends;
  const Frame& frame;
  const FilmWindow& window;
  int scale;
  int margin = 0;  // how far beside a tile's pixels its rays go [pixels]

  // Whether a tile is so far from the region that is asked for at most [tiles].
  [[nodiscard]] bool is_within(int distance, std::size_t tile) const {
    const auto columns = static_cast<std::size_t>(tiles.columns());
    return window.is_within(distance, {tile % columns, tile / columns});
  }

  // The pixels that a tile's samples cover.
  [[nodiscard]] CameraRays::PixelRectangle pixels(std::size_t tile) const;
  // The same without those that other tiles cover too.
  [[nodiscard]] CameraRays::PixelRectangle own_pixels(std::size_t tile) const;
  // Where a position on the whole film lies in a tile, see TileRays::positions.
  [[nodiscard]] glm::vec2 place(std::size_t tile, const glm::dvec2& position) const;
  // The cone of their rays.
  [[nodiscard]] TileCone cone(std::size_t tile) const;
};

// An airlight method.
struct AirlightIntegrator {
  // Evaluates the rays of one tile; `gaussians` are those that may contribute. Returns the number
  // of Gaussian x ray pairs evaluated. Thread-safe.
  using Evaluate = std::function<std::uint64_t(std::span<const std::uint32_t> gaussians,
                                               const TileRays& rays, const TileAirlight& out)>;
  Evaluate evaluate;
  // Called once with all tiles before any is evaluated. May be empty.
  std::function<void(const FilmTiles& film)> prepare{};
  // Evaluates rays that are not of the film; empty: the method has none. Thread-safe.
  AirlightAlong along{};
};

struct FilmAirlight {
  Tiles::Lists lists;  // of the tiles of sample_film()
  std::uint64_t pairs = 0;
  std::size_t gaussians_used = 0;  // that reach any ray
  std::size_t exact_pixels = 0;    // pixels evaluated by the method itself
};

// Depth difference [u] up to which airlight may still be interpolated: small against the Gaussians
// of the tile and the fog's mean free path.
float distance_tolerance(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                         double tolerance);

// Fills frame.airlight, frame.transmittance and the pairs per pixel, tile by tile. All layers must
// be allocated, the depth layer filled.
//
// With settings.airlight_scale 2 or 4 the method runs at every second or fourth pixel of each row
// and column; the others are upsampled to a tolerance of settings.upsampling_tolerance, relative to
// `airlight_rms`, or if absent that of the samples, and to a transmittance of 1. Pixels that
// upsample() cannot resolve and those nearest to `lights` are evaluated exactly.
FilmAirlight film_airlight(const MediumIndex& medium, std::span<const PointLight> lights,
                           const CameraRays& rays, const FilmWindow& window,
                           const Settings& settings, std::optional<double> airlight_rms,
                           const AirlightIntegrator& method, const RayEnds& ends, const Job& job,
                           Frame& frame);

}  // namespace brume
