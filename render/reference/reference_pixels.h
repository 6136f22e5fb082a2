#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/visibility.h"
#include "render/fog_end.h"
#include "render/medium_index.h"
#include "render/reference/occluders.h"
#include "render/reference/reference_airlight.h"

namespace brume {

// The converged airlight of any pixels of one view: what its frames are held against.
class ReferencePixels {
 public:
  // `time` as of Settings [s]; `tolerance` the relative one of each ray's quadrature.
  ReferencePixels(const Scene& scene, const Camera& camera, const Film& film, double time,
                  double tolerance);

  // Of pixels of the film, by row from the top; in parallel, milliseconds each. Empty if `stop` was
  // requested. `progress` as of FrameRenderer.
  [[nodiscard]] std::vector<glm::dvec3> airlight(
      std::span<const std::size_t> pixels, const std::stop_token& stop,
      const std::function<void(double)>& progress = {}) const;

 private:
  // Colour channels with one albedo, see albedo.h.
  struct Group {
    std::vector<std::size_t> channels;
    double albedo;
    MediumIndex medium;
    std::optional<ReferenceEnvironment> environment;
  };

  CameraRays rays_;
  std::size_t width_;
  double tolerance_;
  Visibility visibility_;
  Occluders occluders_;
  double ray_end_;
  std::vector<ReferenceLight> lights_;
  std::vector<Group> groups_;
};

}  // namespace brume
