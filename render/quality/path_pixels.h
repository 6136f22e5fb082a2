#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "render/geometry/medium_index.h"
#include "render/paths/camera_ray.h"
#include "render/paths/environment_sampler.h"
#include "render/paths/path_medium.h"
#include "render/paths/path_scene.h"
#include "render/paths/path_sums.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// The airlight of a pixel and how sure it is.
struct PixelAirlight {
  glm::dvec3 radiance{0.0};
  double variance = 0.0;  // of all channels together; 0 if it is converged
};

// The paths of a pixel so far.
struct PixelPaths {
  int count = 0;
  double work = 0.0;             // that they cost, see work.h
  std::array<PathSums, 3> sums;  // of the channels of one albedo each
};

// Airlight at arbitrary pixels of one view, by path tracing.
class PathPixels {
 public:
  // The light that they are traced for: all, what is scattered once that integrals lack (of area
  // lights; where there are panes, of all), or the latter and what is scattered more often.
  enum class Orders { all, integrals_lack_once, all_but_integrals };
  PathPixels(const Scene& scene, const Camera& camera, const Film& film, Orders orders);

  // Adds paths to a pixel, a row-major index, until they are `count`. The same whatever other
  // pixels are asked for, and in how many pieces. Once `stop` is requested, `paths` is invalid.
  void trace(std::size_t pixel, int count, PixelPaths& paths, const std::stop_token& stop) const;

  // By all paths of a pixel.
  [[nodiscard]] PixelAirlight airlight(const PixelPaths& paths) const;

 private:
  // Channels of one albedo; see prepare/albedo.h. Its parts refer to each other.
  struct Group {
    glm::dvec3 channels{0.0};  // 1 for its own
    double albedo;
    std::shared_ptr<const RayCaster> ray_caster;  // of its own channels; null: that of all
    std::unique_ptr<MediumIndex> index;
    std::unique_ptr<PathMedium> medium;
    std::unique_ptr<PathScene> scene;
    std::unique_ptr<PathScene> area_lights;  // that are alone in the scene; null: there are none
  };
  // The length of the view ray of a position on the film as far as a surface, which may be a pane
  // that the ray does not pass by chance.
  [[nodiscard]] double view_length(const Group& group, double x, double y,
                                   PathRandom& random) const;
  [[nodiscard]] glm::dvec3 trace(const Group& group, const CameraRay& ray,
                                 const StratifiedPair& stratified, PathRandom& random) const;

  CameraRays rays_;
  std::size_t width_;
  Orders orders_;
  std::vector<Surface> surfaces_;
  std::shared_ptr<const RayCaster> ray_caster_;
  double ray_end_;
  std::unique_ptr<EnvironmentSampler> environment_;
  std::vector<Group> groups_;
};

}  // namespace brume
