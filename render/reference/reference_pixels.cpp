#include "render/reference/reference_pixels.h"

#include <algorithm>

#include "render/prepare/albedo.h"
#include "render/prepare/point_sources.h"
#include "render/render_plan.h"
#include "render/util/job.h"

namespace brume {

namespace {

Scene with_lights(Scene scene, ReferencePixels::Lights lights) {
  std::erase_if(scene.lights, [lights](const Light& light) {
    return lights == ReferencePixels::Lights::none || area_of(light).has_value();
  });
  for (Surface& surface : scene.surfaces) {
    surface.material.metallic_roughness.emissive = glm::dvec3(0.0);
  }
  return scene;
}

}  // namespace

ReferencePixels::ReferencePixels(const Scene& scene, const Camera& camera, const Film& film,
                                 double tolerance, Lights lights)
    : rays_(camera, film),
      width_(static_cast<std::size_t>(film.width)),
      tolerance_(tolerance),
      ray_caster_(shared_ray_caster(scene.surfaces)),
      light_shapes_(scene.lights),
      exact_occlusion_(scene.surfaces) {
  Settings settings;
  settings.airlight = AirlightMethod::reference;
  const RenderPlan plan(lights == Lights::all ? scene : with_lights(scene, lights), film, settings);
  const FogExtent fog_extent(scene);
  ray_end_ = fog_extent.ray_distance(rays_);
  lights_ = point_sources(plan.lights, rays_, camera, fog_extent);
  for (const AlbedoGroup& group : albedo_groups(scene)) {
    const Medium extinction = extinction_medium(scene, group);
    MediumIndex medium(extinction, culling_tolerance(extinction, plan.depth_error),
                       scene.optics.anisotropy);
    medium.set_noise(RayNoise(scene.optics.noise, scene.time));
    medium.set_fog(fog_extent.fog());
    std::optional<ReferenceEnvironment> environment;
    if (plan.has_environment) {
      environment.emplace(*scene.environment, scene.optics.anisotropy,
                          fog_extent.surface_optical_depth(medium.homogeneous_density()),
                          tolerance);
    }
    groups_.push_back({group.channels, group.albedo, std::move(medium), std::move(environment)});
  }
}

std::vector<glm::dvec3> ReferencePixels::airlight(
    std::span<const std::size_t> pixels, const std::stop_token& stop,
    const std::function<void(double)>& progress) const {
  const Job job{stop, progress};
  const auto group_count = static_cast<double>(groups_.size());
  std::vector<glm::dvec3> result(pixels.size(), glm::dvec3(0.0));
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    const auto before = static_cast<double>(g);
    job.subrange(before / group_count, (before + 1.0) / group_count)
        .parallel_for_with_progress(pixels.size(), [&](std::size_t k) {
          const double x = static_cast<double>(pixels[k] % width_) + 0.5;
          const double y = static_cast<double>(pixels[k] / width_) + 0.5;
          SurfaceHit hit = ray_caster_->first_hit(rays_, x, y);
          light_shapes_.meet(rays_.origin(x, y), rays_.direction(x, y), hit);
          const double length = std::min(hit.distance, ray_end_);
          const glm::dvec3 airlight =
              reference_airlight(group.medium, exact_occlusion_, lights_,
                                 group.environment ? &*group.environment : nullptr,
                                 rays_.origin(x, y), rays_.direction(x, y), length, tolerance_)
                  .airlight;
          for (const std::size_t c : group.channels) {
            result[k][static_cast<int>(c)] = group.albedo * airlight[static_cast<int>(c)];
          }
        });
  }
  if (stop.stop_requested()) result.clear();
  return result;
}

}  // namespace brume
