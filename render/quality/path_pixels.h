#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "render/geometry/medium_index.h"
#include "render/paths/environment_sampler.h"
#include "render/paths/path_medium.h"
#include "render/paths/path_scene.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// The airlight of a pixel and how sure it is.
struct PixelAirlight {
  glm::dvec3 radiance{0.0};
  double variance = 0.0;  // of all channels together; 0 if it is converged
};

// Airlight at arbitrary pixels of one view, by path tracing: of all orders of scattering, or of all
// but the first.
class PathPixels {
 public:
  enum class Orders { all, after_first };
  PathPixels(const Scene& scene, const Camera& camera, const Film& film, int paths, Orders orders);

  // In parallel; pixels are row-major indices. The same whatever other pixels are asked for. Empty
  // if `stop` was requested. `progress`: see FrameRenderer.
  [[nodiscard]] std::vector<PixelAirlight> airlight(
      std::span<const std::size_t> pixels, const std::stop_token& stop,
      const std::function<void(double)>& progress = {}) const;

 private:
  // Channels of one albedo; see prepare/albedo.h. Its parts refer to each other.
  struct Group {
    glm::dvec3 channels{0.0};  // 1 for its own
    double albedo;
    std::unique_ptr<MediumIndex> index;
    std::unique_ptr<PathMedium> medium;
    std::unique_ptr<PathScene> scene;
  };

  CameraRays rays_;
  std::size_t width_;
  int paths_;
  Orders orders_;
  std::vector<Surface> surfaces_;
  RayCaster ray_caster_;
  double ray_end_;
  std::unique_ptr<EnvironmentSampler> environment_;
  std::vector<Group> groups_;
};

}  // namespace brume
