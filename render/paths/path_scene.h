#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/scene.h"
#include "render/geometry/fog_ball.h"
#include "render/geometry/point_source.h"
#include "render/paths/area_sampler.h"
#include "render/paths/emitter_sampler.h"
#include "render/paths/environment_sampler.h"
#include "render/paths/material_sampler.h"
#include "render/paths/path_medium.h"
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"

namespace brume {

struct PathLight : PointSource {
  // Closer than this, light scattered by the medium around is found by equi-angular samples,
  // farther away by collisions; 0 without medium there. See PathScene::set_lights() [u].
  double near_radius = 0.0;
  std::optional<AreaSampler> sampler{};  // of an area

  explicit PathLight(const PointSource& source) : PointSource(source) {
    if (area) sampler.emplace(*area, position);
  }

  // RGB in the unit direction w from it [W/sr].
  [[nodiscard]] glm::dvec3 intensity_along(const glm::dvec3& w) const {
    return falloff.at(w) * intensity;
  }

  // A point of it, evenly over its area, and what all of it would send from there to x [W/sr].
  [[nodiscard]] AreaSampler::Point point(PathRandom& random) const;
  [[nodiscard]] glm::dvec3 intensity_towards(const AreaSampler::Point& point,
                                             const glm::dvec3& x) const;

  // The same as x sees it: a point drawn for it.
  struct Seen {
    glm::dvec3 position{0.0};
    glm::dvec3 intensity{0.0};  // towards x [W/sr]
  };
  [[nodiscard]] Seen seen_from(const glm::dvec3& x, PathRandom& random) const;
  // Density of seen_from() finding a point of an area light, per solid angle at x [1/sr].
  [[nodiscard]] double direction_pdf(const glm::dvec3& x, const glm::dvec3& point) const {
    return sampler->direction_pdf(x, point);
  }

  // Roughly how much of it arrives at x [W/u^2].
  [[nodiscard]] double importance(const glm::dvec3& x) const;
};

// Where homogeneous fog is.
struct PathFog {
  double density = 0.0;  // b0 [1/u]
  FogBall ball;
  bool is_everywhere = true;  // whether view rays and walks begin in it, wherever they do
  // The radius of the ball around everything that sends or scatters light, in endless fog; else 0
  // [u].
  double scene_radius = 0.0;

  // Without an environment fog is endless. Walks in it are followed to this many mean free paths
  // beyond the scene: at albedo 1 a hundredth of the light that is scattered often comes from
  // farther away, at albedo 0.99 nothing.
  static constexpr double max_free_paths = 100.0;

  // `extent`: see FogExtent::ball(); what is endless there ends far around all that sends or
  // scatters light. View rays start within `max_offset` of the eye.
  static PathFog around(const MediumIndex& medium, const RayCaster& ray_caster,
                        std::span<const PointSource> lights, const glm::dvec3& eye,
                        const FogBall& extent, double max_offset = 0.0);

  // Whether no environment limits it.
  [[nodiscard]] bool is_endless() const { return scene_radius > 0.0; }
  // Length of a ray from x in the unit direction w in it [u].
  [[nodiscard]] double length(const glm::dvec3& x, const glm::dvec3& w) const;
  // Where it is. Only `medium.extent` keeps it from beginning at x.
  [[nodiscard]] FogInterval interval(const glm::dvec3& x, const glm::dvec3& w) const;
  [[nodiscard]] double density_at(const glm::dvec3& x) const {
    return !is_everywhere && !ball.contains(x) ? 0.0 : density;
  }

  // The importance of a collision at x, relative to one in the scene: in endless fog light
  // diffuses like 1 / distance. (A steeper fall is as cheap for its noise, but leaves outliers.)
  [[nodiscard]] double importance(const glm::dvec3& x) const;
};

// One albedo group of a scene, in which paths are traced; its medium's densities are extinction.
// The objects that it refers to outlive it.
struct PathScene {
  const PathMedium& medium;
  double albedo = 1.0;
  PathFog fog;
  std::vector<PathLight> lights{};
  const LightShapes* light_shapes = nullptr;        // null: no light is seen
  const EnvironmentSampler* environment = nullptr;  // null: none, or black
  EmissionSampler emission{};                       // of Gaussians
  EmitterSampler emitters{};                        // of surfaces
  const RayCaster& ray_caster;
  std::span<const Surface> surfaces;
  std::vector<MaterialSampler> materials{};  // of the surfaces
  bool is_mirrored_alone = false;            // see Settings::mirrored_alone

  // Sets the lights and their near_radius.
  void set_lights(std::span<const PointSource> all);

  // The scene of a view. `environment` may be null; `fog` as of FogExtent::ball(), `max_offset` as
  // of CameraRays.
  static PathScene of_view(const PathMedium& medium, double albedo, const RayCaster& ray_caster,
                           std::span<const Surface> surfaces, const EnvironmentSampler* environment,
                           std::span<const PointSource> lights, const glm::dvec3& eye,
                           const FogBall& fog, double max_offset = 0.0);

  [[nodiscard]] double anisotropy() const { return medium.index().anisotropy(); }
};

}  // namespace brume
