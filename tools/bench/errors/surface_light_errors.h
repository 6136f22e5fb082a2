#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "brume/frame.h"
#include "render/reference/surface_reference.h"
#include "tools/bench/errors/unbiased_error.h"

namespace brume {

// Error of point light scattered onto surfaces by fog against Monte Carlo, and with the paper's
// single point spread function: a ball with the light in homogeneous fog, relative to the scattered
// light; balls in clouds of 30 Gaussians of optical depth 3 with the light outside, relative to
// that and to all reflected light. `samples`: per run and pixel, a tenth of them in clouds.
std::vector<ComparedError> measure_surface_light(std::size_t samples);

// Outgoing radiance of surfaces at pixel centers by Monte Carlo: ground truth for frames of that
// view.
class SurfaceTruth {
 public:
  // One run of Monte Carlo at one point; thread-safe.
  using Run =
      std::function<ReflectedLight(const RayCaster&, const SurfacePoint&, const SurfaceSampling&)>;

  // By reflected_light(). `sampling` is that of one of the independent_runs, whose seeds begin with
  // its own.
  SurfaceTruth(const Scene& scene, const SurfaceSampling& sampling);
  SurfaceTruth(const Scene& scene, const SurfaceSampling& sampling, const Run& run);

  // Pixels that show a surface.
  [[nodiscard]] std::size_t size() const { return pixels_.size(); }

  // How far what the surfaces of a frame reflect is from it, without airlight and as if no medium
  // were between surface and eye: relative to all that they reflect, and to the part of it that the
  // medium scattered on its way to them. The frame is of the same view and film.
  [[nodiscard]] ErrorEstimate error(const Frame& frame) const;
  [[nodiscard]] ErrorEstimate scattered_error(const Frame& frame) const;

 private:
  [[nodiscard]] Runs differences(const Frame& frame) const;

  std::vector<std::size_t> pixels_;
  Runs all_, scattered_;
};

}  // namespace brume
