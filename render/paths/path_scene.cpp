#include "render/paths/path_scene.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/math/max_component.h"

namespace brume {

AreaSampler::Point PathLight::point(PathRandom& random) const {
  return sampler ? sampler->on_surface(random) : AreaSampler::Point{position};
}

glm::dvec3 PathLight::intensity_towards(const AreaSampler::Point& point,
                                        const glm::dvec3& x) const {
  if (sampler) return sampler->cosine(point, x) * intensity;
  const glm::dvec3 q = x - position;
  return intensity_along(q / std::max(glm::length(q), 1e-30));
}

PathLight::Seen PathLight::seen_from(const glm::dvec3& x, PathRandom& random) const {
  if (!sampler) return {position, intensity_towards({position}, x)};
  const AreaSampler::SeenPoint seen = sampler->seen_from(x, random);
  return {seen.position, seen.factor * intensity};
}

double PathLight::importance(const glm::dvec3& x) const {
  const glm::dvec3 q = x - position;
  const double r2 = std::max({glm::dot(q, q), h_min * h_min, 1e-30});
  if (!area) return max_component(intensity_towards({position}, x)) / r2;
  if (!sampler->shines_to(x)) return 0.0;
  return max_component(intensity) / std::max(r2, facing_area(*area));
}

PathFog PathFog::around(const MediumIndex& medium, const RayCaster& ray_caster,
                        std::span<const PointSource> lights, const glm::dvec3& eye,
                        const FogBall& extent, double max_offset) {
  PathFog fog;
  const double density = medium.homogeneous_density();
  if (!(density > 0.0)) return fog;
  fog.density = density;
  fog.ball = extent;
  fog.is_everywhere = medium.fog().is_endless();
  if (!extent.is_endless()) return fog;
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  const auto add = [&](const glm::dvec3& p, double margin) {
    low = glm::min(low, p - margin);
    high = glm::max(high, p + margin);
  };
  for (const GaussianTerm<double>& g : medium.gaussians()) {
    if (g.c > 0.0) add(g.b, 3.0 / g.a);
  }
  if (!ray_caster.empty()) {
    add(ray_caster.bounds().low, 0.0);
    add(ray_caster.bounds().high, 0.0);
  }
  for (const PointSource& light : lights) {
    if (!light.is_far) add(light.position, light.area ? bounding_radius(*light.area) : 0.0);
  }
  if (!(low.x <= high.x)) low = high = eye;
  fog.ball.center = 0.5 * (low + high);
  const double eye_distance = glm::length(eye - fog.ball.center) + max_offset;
  fog.scene_radius = std::max(0.5 * glm::length(high - low), eye_distance) + 1.0 / density;
  fog.ball.radius = fog.scene_radius + max_free_paths / density;
  return fog;
}

double PathFog::length(const glm::dvec3& x, const glm::dvec3& w) const {
  return density > 0.0 ? ball.length(x, w) : 0.0;
}

FogInterval PathFog::interval(const glm::dvec3& x, const glm::dvec3& w) const {
  if (!(density > 0.0)) return {0.0, 0.0};
  return is_everywhere ? FogInterval{0.0, ball.length(x, w)} : ball.interval(x, w);
}

double PathFog::importance(const glm::dvec3& x) const {
  if (!is_endless()) return 1.0;
  return scene_radius / std::max(glm::length(x - ball.center), scene_radius);
}

void PathScene::set_lights(std::span<const PointSource> all) {
  lights.clear();
  for (const PointSource& light : all) lights.emplace_back(light);
  const MajorantGrid& grid = medium.grid();
  double max_density = fog.density;
  for (const GaussianTerm<double>& g : medium.index().gaussians()) {
    max_density = std::max(max_density, fog.density + g.c);
  }
  const double extent =
      grid.empty() ? 0.0 : 0.5 * glm::length(grid.bounds().high - grid.bounds().low);
  for (PathLight& light : lights) {
    if (light.is_far || light.area) continue;  // those of surfaces stay bounded
    const double density = fog.density_at(light.position) + medium.density(light.position);
    if (!(density > 0.0)) continue;
    // A mean free path; less where the bulk of the medium is denser, since the light's surroundings
    // then scatter little of what the bulk does, and equi-angular samples know nothing of the bulk.
    const double bulk = density < max_density ? extent * density / max_density : 1.0 / density;
    light.near_radius = std::min(1.0 / density, bulk);
  }
}

PathScene PathScene::of_view(const PathMedium& medium, double albedo, const RayCaster& ray_caster,
                             std::span<const Surface> surfaces,
                             const EnvironmentSampler* environment,
                             std::span<const PointSource> lights, const glm::dvec3& eye,
                             const FogBall& fog, double max_offset) {
  PathScene scene{.medium = medium,
                  .albedo = albedo,
                  .fog = PathFog::around(medium.index(), ray_caster, lights, eye, fog, max_offset),
                  .ray_caster = ray_caster,
                  .surfaces = surfaces};
  if (environment && !environment->empty()) scene.environment = environment;
  for (const Surface& surface : surfaces) scene.materials.emplace_back(surface.material);
  scene.emission = EmissionSampler(medium.index());
  scene.emitters = EmitterSampler(surfaces);
  scene.set_lights(lights);
  return scene;
}

}  // namespace brume
