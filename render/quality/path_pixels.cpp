#include "render/quality/path_pixels.h"

#include <algorithm>
#include <cmath>

#include "render/paths/path_tracer.h"
#include "render/prepare/albedo.h"
#include "render/prepare/fog_extent.h"
#include "render/prepare/point_sources.h"
#include "render/quality/work.h"
#include "render/render_plan.h"
#include "render/visibility/holdout.h"

namespace brume {
namespace {

// Depths of less have no airlight.
constexpr double min_depth = 1e-200;

// The seed of the random numbers, other than those of frames.
constexpr std::uint64_t pixel_seed = 0x6d65;

}  // namespace

PathPixels::PathPixels(const Scene& scene, const Camera& camera, const Film& film, Orders airlight,
                       Orders picture)
    : rays_(camera, film),
      width_(static_cast<std::size_t>(film.width)),
      airlight_orders_(airlight),
      picture_orders_(picture),
      surfaces_(scene.surfaces),
      ray_caster_(shared_ray_caster(surfaces_)),
      light_shapes_(scene.lights) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  const RenderPlan plan(scene, film, settings);
  const FogExtent fog_extent(scene);
  ray_end_ = fog_extent.ray_distance(rays_);
  if (plan.has_environment) environment_ = std::make_unique<EnvironmentSampler>(*scene.environment);
  const std::vector<PointSource> lights = point_sources(plan.lights, rays_, camera, fog_extent);
  std::vector<PointSource> area_lights = lights;
  std::erase_if(area_lights, [this](const PointSource& light) {
    if (ray_caster_->has_panes()) return false;
    return !light.area || light.is_far;  // the integral has the disc of a sun
  });
  for (const AlbedoGroup& each : albedo_groups(scene)) {
    Group& group = groups_.emplace_back();
    group.albedo = each.albedo;
    for (const std::size_t c : each.channels) group.channels[static_cast<int>(c)] = 1.0;
    const Medium extinction = extinction_medium(scene, each);
    group.index = std::make_unique<MediumIndex>(
        extinction, culling_tolerance(extinction, plan.depth_error), scene.optics.anisotropy);
    group.index->set_noise(RayNoise(scene.optics.noise, scene.time));
    group.index->set_fog(fog_extent.fog());
    if (ray_caster_->has_panes()) {
      group.ray_caster = shared_ray_caster(surfaces_, channel_weights(each));
    }
    const RayCaster& ray_caster = group.ray_caster ? *group.ray_caster : *ray_caster_;
    group.medium = std::make_unique<PathMedium>(*group.index);
    group.scene = std::make_unique<PathScene>(
        PathScene::of_view(*group.medium, each.albedo, ray_caster, surfaces_, environment_.get(),
                           lights, rays_.eye(), fog_extent.ball(), rays_.max_offset()));
    if (!light_shapes_.empty()) group.scene->light_shapes = &light_shapes_;
    const bool has_areas = !area_lights.empty() || !group.scene->emitters.empty();
    if (airlight_orders_ == Orders::all || !has_areas) continue;
    group.area_lights = std::make_unique<PathScene>(
        PathScene::of_view(*group.medium, each.albedo, ray_caster, surfaces_, nullptr, area_lights,
                           rays_.eye(), fog_extent.ball(), rays_.max_offset()));
  }
}

void PathPixels::trace(std::size_t pixel, int count, PixelPaths& paths,
                       const std::stop_token& stop) const {
  const double x = static_cast<double>(pixel % width_) + 0.5;
  const double y = static_cast<double>(pixel / width_) + 0.5;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    const bool has_panes = group.ray_caster != nullptr;
    PathRandom first_random(pixel_seed, pixel, 0, 2);
    const glm::dvec3 eye = rays_.origin(x, y);
    const glm::dvec3 w = rays_.direction(x, y);
    SurfaceHit hit = view_hit(group, x, y, first_random);
    std::optional<CameraRay> ray;
    ray.emplace(*group.index, eye, w, std::min(hit.distance, ray_end_));
    const bool has_picture = picture_orders_ != Orders::none;
    if (!has_panes && !has_picture && !(ray->depth() > min_depth)) continue;
    for (int k = paths.count; k < count && !stop.stop_requested(); ++k) {
      const auto sample = static_cast<std::uint64_t>(k);
      const PathRandom block(pixel_seed, pixel, sample / path_block, 0);
      PathRandom random(pixel_seed, pixel, sample, 1);
      const PathRandom start = random;
      const StratifiedPair stratified(block, static_cast<unsigned>(k % path_block), random);
      if (has_panes) {
        PathRandom by_chance(pixel_seed, pixel, sample, 2);
        hit = view_hit(group, x, y, by_chance);
        ray.emplace(*group.index, eye, w, std::min(hit.distance, ray_end_));
      }
      const TracedAirlight traced =
          ray->depth() > min_depth ? trace(group, *ray, stratified, random) : TracedAirlight{};
      paths.airlight[i].add(k, traced.airlight, group.channels);
      paths.work += path_work(group.index->size(), random.drawn_since(start));
      if (!has_picture) continue;
      PathRandom from_surface(pixel_seed, pixel, sample, 3);
      const PathRandom surface_start = from_surface;
      paths.picture[i].add(
          k, group.albedo * traced.in_picture + behind(group, *ray, hit, from_surface),
          group.channels);
      paths.work += path_work(group.index->size(), from_surface.drawn_since(surface_start));
    }
  }
  paths.count = std::max(paths.count, count);
}

SurfaceHit PathPixels::view_hit(const Group& group, double x, double y, PathRandom& random) const {
  const glm::dvec3 eye = rays_.origin(x, y);
  const glm::dvec3 w = rays_.direction(x, y);
  const auto by_chance = [&] {
    const double clipped = rays_.clip_end(eye, w);
    if (!std::isfinite(clipped)) return SurfaceHit();
    SurfaceHit passed = group.ray_caster->first_hit_by_chance(
        eye + clipped * w, w, [&random] { return random.uniform(); });
    passed.distance += clipped;
    return passed;
  };
  SurfaceHit hit = group.ray_caster ? by_chance() : ray_caster_->first_hit(rays_, x, y);
  light_shapes_.meet(eye, w, hit);
  return hit;
}

glm::dvec3 PathPixels::behind(const Group& group, const CameraRay& ray, const SurfaceHit& hit,
                              PathRandom& random) const {
  const glm::dvec3 none(0.0);
  if (ray.depth() > PathTracer::hidden_depth) return none;
  const double transmittance = std::exp(-ray.depth());
  if (!hit) return environment_ ? transmittance * environment_->radiance(ray.w()) : none;
  if (is_held_out(surfaces_, hit)) return none;
  if (hit.is_light()) return transmittance * glm::dvec3(light_shapes_.of(hit).radiance);
  const RayCaster& ray_caster = group.scene->ray_caster;
  const SurfacePoint point = ray_caster.point(hit, ray.eye(), ray.w(), surfaces_);
  return transmittance * ray_caster.reflected_by_chance(hit) *
         PathTracer(*group.scene).surface(point, random).sum();
}

PathPixels::TracedAirlight PathPixels::trace(const Group& group, const CameraRay& ray,
                                             const StratifiedPair& stratified,
                                             PathRandom& random) const {
  using enum Orders;
  const auto needs = [this](Orders orders) {
    return airlight_orders_ == orders || picture_orders_ == orders;
  };
  OrderedRadiance radiance;
  if (needs(all) || needs(all_but_integrals)) {
    radiance = PathTracer(*group.scene).airlight(ray, stratified, random);
  }
  glm::dvec3 lacking(0.0);
  if (group.area_lights && (needs(integrals_lack_once) || needs(all_but_integrals))) {
    lacking = PathTracer(*group.area_lights).lights_once(ray, stratified, random);
  }
  const auto light_of = [&](Orders orders) {
    if (orders == all) return radiance.sum();
    if (orders == none) return glm::dvec3(0.0);
    if (orders == integrals_lack_once) return lacking;
    return radiance.sum() - radiance.orders[0] + lacking;
  };
  return {light_of(airlight_orders_), light_of(picture_orders_)};
}

PixelRadiance PathPixels::airlight(const PixelPaths& paths) const {
  PixelRadiance result;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    result.radiance += group.albedo * group.channels * paths.airlight[i].mean(paths.count);
    result.variance +=
        group.albedo * group.albedo * paths.airlight[i].variance(paths.count, group.channels);
  }
  return result;
}

PixelRadiance PathPixels::picture(const PixelPaths& paths) const {
  PixelRadiance result;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const glm::dvec3& channels = groups_[i].channels;
    result.radiance += channels * paths.picture[i].mean(paths.count);
    result.variance += paths.picture[i].variance(paths.count, channels);
  }
  return result;
}

}  // namespace brume
