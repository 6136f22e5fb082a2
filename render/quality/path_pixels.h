#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
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
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// The light of a pixel and how sure it is.
struct PixelRadiance {
  glm::dvec3 radiance{0.0};
  double variance = 0.0;  // of all channels together; 0 if it is converged
};

// The paths of a pixel so far.
struct PixelPaths {
  int count = 0;
  double work = 0.0;                 // that they cost, see work.h
  std::array<PathSums, 3> airlight;  // of the channels of one albedo each
  std::array<PathSums, 3> picture;
};

// Airlight and pictures at arbitrary pixels of one view, by path tracing.
class PathPixels {
 public:
  // The airlight that they are traced for: all, what is scattered once that integrals lack (of area
  // lights; where there are panes, of all), the latter and what is scattered more often, or none.
  enum class Orders { all, integrals_lack_once, all_but_integrals, none };
  // `picture`: the airlight that is traced for pictures, beside the surfaces and the environment
  // behind it; `none`: they have none.
  PathPixels(const Scene& scene, const Camera& camera, const Film& film, Orders airlight,
             Orders picture);

  // Adds paths to a pixel, a row-major index, until they are `count`. The same whatever other
  // pixels are asked for, and in how many pieces. Once `stop` is requested, `paths` is invalid.
  void trace(std::size_t pixel, int count, PixelPaths& paths, const std::stop_token& stop) const;

  // By all paths of a pixel.
  [[nodiscard]] PixelRadiance airlight(const PixelPaths& paths) const;
  [[nodiscard]] PixelRadiance picture(const PixelPaths& paths) const;

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
  // The surface or light that the view ray of a position on the film sees; that may be a pane that
  // the ray does not pass by chance.
  [[nodiscard]] SurfaceHit view_hit(const Group& group, double x, double y,
                                    PathRandom& random) const;
  // The light of a ray's hit, attenuated.
  [[nodiscard]] glm::dvec3 behind(const Group& group, const CameraRay& ray, const SurfaceHit& hit,
                                  PathRandom& random) const;
  // The airlight of one path, for the airlight alone and as a part of the picture.
  struct TracedAirlight {
    glm::dvec3 airlight{0.0};
    glm::dvec3 in_picture{0.0};
  };
  [[nodiscard]] TracedAirlight trace(const Group& group, const CameraRay& ray,
                                     const StratifiedPair& stratified, PathRandom& random) const;

  CameraRays rays_;
  std::size_t width_;
  Orders airlight_orders_;
  Orders picture_orders_;
  std::vector<Surface> surfaces_;
  std::shared_ptr<const RayCaster> ray_caster_;
  LightShapes light_shapes_;
  double ray_end_;
  std::unique_ptr<EnvironmentSampler> environment_;
  std::vector<Group> groups_;
};

}  // namespace brume
