#include "render/quality/path_pixels.h"

#include <algorithm>

#include "render/paths/camera_ray.h"
#include "render/paths/path_tracer.h"
#include "render/prepare/albedo.h"
#include "render/prepare/fog_extent.h"
#include "render/prepare/point_sources.h"
#include "render/render_plan.h"

namespace brume {
namespace {

// Depths of less have no airlight.
constexpr double min_depth = 1e-200;

// The seed of the random numbers, other than those of frames.
constexpr std::uint64_t pixel_seed = 0x6d65;

}  // namespace

PathPixels::PathPixels(const Scene& scene, const Camera& camera, const Film& film, Orders orders)
    : rays_(camera, film),
      width_(static_cast<std::size_t>(film.width)),
      orders_(orders),
      surfaces_(scene.surfaces),
      ray_caster_(surfaces_) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  const RenderPlan plan(scene, film, settings);
  const FogExtent fog_extent(scene);
  ray_end_ = fog_extent.ray_distance(rays_);
  if (plan.has_environment) environment_ = std::make_unique<EnvironmentSampler>(*scene.environment);
  const std::vector<PointSource> lights =
      point_sources(plan.lights, rays_, camera, fog_extent.ball());
  for (const AlbedoGroup& each : albedo_groups(scene)) {
    Group& group = groups_.emplace_back();
    group.albedo = each.albedo;
    for (const std::size_t c : each.channels) group.channels[static_cast<int>(c)] = 1.0;
    const Medium extinction = extinction_medium(scene, each);
    group.index = std::make_unique<MediumIndex>(
        extinction, culling_tolerance(extinction, plan.depth_error), scene.optics.anisotropy);
    group.index->set_noise(RayNoise(scene.optics.noise, scene.time));
    group.medium = std::make_unique<PathMedium>(*group.index);
    group.scene = std::make_unique<PathScene>(
        PathScene::of_view(*group.medium, each.albedo, ray_caster_, surfaces_, environment_.get(),
                           lights, rays_.eye(), fog_extent.ball(), rays_.max_offset()));
  }
}

void PathPixels::trace(std::size_t pixel, int count, PixelPaths& paths,
                       const std::stop_token& stop) const {
  const double x = static_cast<double>(pixel % width_) + 0.5;
  const double y = static_cast<double>(pixel / width_) + 0.5;
  const double length = std::min(ray_caster_.first_hit(rays_, x, y).distance, ray_end_);
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    const CameraRay ray(*group.index, rays_.origin(x, y), rays_.direction(x, y), length);
    if (!(ray.depth() > min_depth)) continue;
    const PathTracer tracer(*group.scene);
    for (int k = paths.count; k < count && !stop.stop_requested(); ++k) {
      const auto sample = static_cast<std::uint64_t>(k);
      const PathRandom block(pixel_seed, pixel, sample / path_block, 0);
      PathRandom random(pixel_seed, pixel, sample, 1);
      const StratifiedPair stratified(block, static_cast<unsigned>(k % path_block), random);
      OrderedRadiance radiance = tracer.airlight(ray, stratified, random);
      if (orders_ == Orders::after_first) radiance.orders[0] = glm::dvec3(0.0);
      paths.sums[i].add(k, radiance.sum(), group.channels);
    }
  }
  paths.count = std::max(paths.count, count);
}

PixelAirlight PathPixels::airlight(const PixelPaths& paths) const {
  PixelAirlight result;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const auto& [channels, albedo, index, medium, scene] = groups_[i];
    result.radiance += albedo * channels * paths.sums[i].mean(paths.count);
    result.variance += albedo * albedo * paths.sums[i].variance(paths.count, channels);
  }
  return result;
}

}  // namespace brume
