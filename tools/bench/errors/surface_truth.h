#pragma once

#include <functional>
#include <vector>

#include "brume/frame.h"
#include "render/reference/surface_reference.h"
#include "tools/bench/errors/unbiased_error.h"

namespace brume {

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
