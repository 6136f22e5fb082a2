#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "render/geometry/medium_index.h"
#include "render/prepare/fog_extent.h"
#include "render/reference/reference_airlight.h"
#include "render/visibility/exact_occlusion.h"
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Converged airlight of arbitrary pixels of one view.
class ReferencePixels {
 public:
  // Which lights count: area lights are hundreds of points each.
  enum class Lights { all, without_area, none };
  // `tolerance`: relative, of each ray's quadrature.
  ReferencePixels(const Scene& scene, const Camera& camera, const Film& film, double tolerance,
                  Lights lights = Lights::all);

  // What each pixel costs: point lights, and whether there is an environment.
  [[nodiscard]] std::size_t light_count() const { return lights_.size(); }
  [[nodiscard]] bool has_environment() const { return groups_.front().environment.has_value(); }

  // Airlight of pixels (row-major indices), in parallel, milliseconds each. Empty if `stop` was
  // requested. `progress`: see FrameRenderer.
  [[nodiscard]] std::vector<glm::dvec3> airlight(
      std::span<const std::size_t> pixels, const std::stop_token& stop,
      const std::function<void(double)>& progress = {}) const;

 private:
  // Channels of one albedo; see albedo.h.
  struct Group {
    std::vector<std::size_t> channels;
    double albedo;
    MediumIndex medium;
    std::optional<ReferenceEnvironment> environment;
  };

  CameraRays rays_;
  std::size_t width_;
  double tolerance_;
  std::shared_ptr<const RayCaster> ray_caster_;
  LightShapes light_shapes_;
  ExactOcclusion exact_occlusion_;
  double ray_end_;
  std::vector<PointSource> lights_;
  std::vector<Group> groups_;
};

}  // namespace brume
