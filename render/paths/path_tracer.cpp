#include "render/paths/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/infinity.h"
#include "core/math/max_component.h"
#include "core/transport/light_path.h"
#include "core/transport/phase_function.h"
#include "render/paths/direction_sampling.h"

namespace brume {
namespace {

using std::numbers::pi;

// A point of the light relative to the segment that ends at a point of the medium.
PointLightRay<double> relative_to(const PathLight& light, const glm::dvec3& point,
                                  const glm::dvec3& start, const glm::dvec3& w) {
  return {point, start, w, light.h_min};
}

}  // namespace

PathTracer::Vertex PathTracer::Vertex::in_medium(const glm::dvec3& start, const glm::dvec3& w,
                                                 double t) {
  return {.position = start + t * w, .w = w, .start = start, .t = t};
}

PathTracer::Vertex PathTracer::Vertex::on_surface(const SurfacePoint& point) {
  return {.position = point.shadow_origin, .w = -point.to_eye, .is_surface = true, .point = point};
}

const MaterialSampler& PathTracer::material(const Vertex& vertex) const {
  return scene_.materials[static_cast<std::size_t>(vertex.point.surface - scene_.surfaces.data())];
}

glm::dvec3 PathTracer::scattering(const Vertex& vertex, const glm::dvec3& l) const {
  if (!vertex.is_surface) {
    return glm::dvec3(henyey_greenstein(glm::dot(vertex.w, l), scene_.anisotropy()) / (4.0 * pi));
  }
  const SurfacePoint& point = vertex.point;
  const double cosine = glm::dot(l, point.normal);
  if (!(cosine > 0.0)) return glm::dvec3(0.0);
  return cosine * brdf(point, l);
}

PathTracer::Direction PathTracer::sample_direction(const Vertex& vertex, PathRandom& random) const {
  if (vertex.is_surface) {
    const SurfacePoint& point = vertex.point;
    const glm::dvec3 w = point.ggx
                             ? GgxSampler(*point.ggx, point.normal, point.to_eye).sample(random)
                             : material(vertex).sample(point.normal, point.to_eye, random);
    return {w, direction_pdf(vertex, w)};
  }
  const double g = scene_.anisotropy();
  const double cosine = henyey_greenstein_quantile(random.uniform(), g);
  return {direction_around(vertex.w, cosine, random), henyey_greenstein(cosine, g) / (4.0 * pi)};
}

double PathTracer::direction_pdf(const Vertex& vertex, const glm::dvec3& l) const {
  if (!vertex.is_surface) return scattering(vertex, l).x;
  const SurfacePoint& point = vertex.point;
  if (point.ggx) return GgxSampler(*point.ggx, point.normal, point.to_eye).pdf(l);
  return material(vertex).pdf(l, point.normal, point.to_eye);
}

PathTracer::Arrival PathTracer::arrival(const Vertex& vertex, const glm::dvec3& point) const {
  const glm::dvec3 q = point - vertex.position;
  const double r = glm::length(q);
  if (!(r > 0.0)) return {};
  return {q / r, r, scattering(vertex, q / r)};
}

double PathTracer::transmittance(const Segment& segment, double length) const {
  const double depth = scene_.medium.depth(segment.origin, segment.w, length) +
                       scene_.fog.density * segment.fog.before(length);
  return std::exp(-depth);
}

RelativeOptics PathTracer::optics_at(const glm::dvec3& x) const {
  return scene_.medium.index().optics_at(x, scene_.fog.density_at(x));
}

template <class Importance, class Visit>
void PathTracer::choose_lights(Importance importance, PathRandom& random, Visit visit) const {
  const std::vector<PathLight>& lights = scene_.lights;
  if (lights.size() <= max_lights_each) {
    for (const PathLight& light : lights) visit(light, 1.0);
    return;
  }
  double sum = 0.0;
  for (const PathLight& light : lights) sum += importance(light);
  if (!(sum > 0.0)) return;
  double u = sum * random.uniform();
  const PathLight* chosen = nullptr;
  double probability = 0.0;
  for (const PathLight& light : lights) {
    const double share = importance(light);
    if (!(share > 0.0)) continue;
    chosen = &light;
    probability = share / sum;
    if ((u -= share) < 0.0) break;
  }
  if (chosen) visit(*chosen, probability);
}

double PathTracer::visibility(const glm::dvec3& x, const PathLight& light,
                              const glm::dvec3& point) const {
  const glm::dvec3 q = point - x;
  const double r = glm::length(q);
  const glm::dvec3 l = q / r;
  const double depth =
      scene_.medium.depth(x, l, r) + scene_.fog.density * light.fog.length(x, l, r);
  const double transmittance = std::exp(-depth);
  if (!(transmittance > 0.0)) return 0.0;
  return transmittance * scene_.ray_caster.transmittance(x, point);
}

template <class Weight>
glm::dvec3 PathTracer::light_at(const Vertex& vertex, Weight weight, PathRandom& random) const {
  glm::dvec3 sum(0.0);
  const auto importance = [&](const PathLight& light) { return light.importance(vertex.position); };
  choose_lights(importance, random, [&](const PathLight& light, double probability) {
    const auto [point, intensity] = light.seen_from(vertex.position, random);
    if (!(max_component(intensity) > 0.0)) return;
    const auto [l, r, value] = arrival(vertex, point);
    if (!(max_component(value) > 0.0)) return;
    const double r2 = vertex.is_surface
                          ? std::max(r * r, light.h_min * light.h_min)
                          : relative_to(light, point, vertex.start, vertex.w).distance2(vertex.t);
    const double factor = weight(light, point) / (probability * r2);
    if (!(factor > 0.0)) return;
    sum += factor * visibility(vertex.position, light, point) * value * intensity *
           shapes_pass(vertex, l, r);
  });
  return sum;
}

glm::dvec3 PathTracer::environment_at(const Vertex& vertex, PathRandom& random) const {
  const EnvironmentSampler* environment = scene_.environment;
  if (!environment) return glm::dvec3(0.0);
  const glm::dvec3 l = environment->sample(random);
  const double pdf = environment->pdf(l);
  const glm::dvec3 value = scattering(vertex, l);
  if (!(pdf > 0.0) || !(max_component(value) > 0.0)) return glm::dvec3(0.0);
  const double visible = scene_.ray_caster.transmittance(vertex.position, l, infinity);
  if (!(visible > 0.0)) return glm::dvec3(0.0);
  const double depth = scene_.medium.depth(vertex.position, l, infinity) +
                       scene_.fog.density * scene_.fog.length(vertex.position, l);
  return visible * std::exp(-depth) / (pdf + direction_pdf(vertex, l)) * value *
         environment->radiance(l) * shapes_pass(vertex, l, infinity);
}

glm::dvec3 PathTracer::emitters_at(const Vertex& vertex, PathRandom& random) const {
  const glm::dvec3 none(0.0);
  if (scene_.emitters.empty()) return none;
  const EmitterSampler::Point drawn = scene_.emitters.sample(random);
  const auto [l, r, value] = arrival(vertex, drawn.position);
  if (!(max_component(value) > 0.0)) return none;
  const Segment way = segment(vertex, l, random);
  const SurfaceHit& hit = way.hit;
  const double pdf = scene_.emitters.pdf(hit, l);
  if (!(pdf > 0.0) || hit.surface != static_cast<std::int32_t>(drawn.surface) ||
      hit.copy != drawn.copy || hit.triangle != drawn.triangle) {
    return none;
  }
  const SurfacePoint point = scene_.ray_caster.point(hit, vertex.position, l, scene_.surfaces);
  return scene_.ray_caster.reflected_by_chance(hit) * transmittance(way, hit.distance) /
         (pdf + direction_pdf(vertex, l)) * value * point.emitted *
         shapes_pass(vertex, l, hit.distance);
}

glm::dvec3 PathTracer::emitters_around(const Vertex& vertex, PathRandom& random) const {
  const glm::dvec3 none(0.0);
  if (scene_.emitters.empty()) return none;
  const Direction direction = sample_direction(vertex, random);
  if (!(direction.pdf > 0.0)) return none;
  const Segment way = segment(vertex, direction.w, random);
  const auto& [origin, w, hit, fog] = way;
  if (!hit) return none;
  const SurfacePoint point = scene_.ray_caster.point(hit, origin, w, scene_.surfaces);
  if (!(max_component(point.emitted) > 0.0)) return none;
  return scene_.ray_caster.reflected_by_chance(hit) * transmittance(way, hit.distance) /
         direction.pdf * scattering(vertex, w) * emitted_by(hit, point, direction);
}

glm::dvec3 PathTracer::emitted_by(const SurfaceHit& hit, const SurfacePoint& point,
                                  const Direction& direction) const {
  const double pdf = scene_.emitters.pdf(hit, direction.w);
  return direction.pdf / (direction.pdf + pdf) * point.emitted;
}

glm::dvec3 PathTracer::emission_at(const Vertex& vertex, PathRandom& random) const {
  const glm::dvec3 none(0.0);
  if (scene_.emission.empty()) return none;
  const auto [l, r, value] = arrival(vertex, scene_.emission.sample(random));
  if (!(max_component(value) > 0.0)) return none;
  const Emission emission = emission_of({vertex.position, l, r}, direction_pdf(vertex, l));
  if (!(emission.collision_pdf + emission.pdf > 0.0)) return none;
  const double visible = scene_.ray_caster.transmittance(vertex.position, l, r);
  if (!(visible > 0.0)) return none;
  return visible * emission.arriving / (emission.collision_pdf + emission.pdf) * value;
}

PathTracer::Emission PathTracer::emission_of(const RaySegment& way, double direction_pdf) const {
  const glm::dvec3 y = way.origin + way.length * way.direction;
  const double density = scene_.medium.density(y);
  const glm::dvec3 emission = scene_.medium.index().optics_at(y, 0.0).emission;
  const Segment segment{
      way.origin, way.direction, {}, scene_.fog.interval(way.origin, way.direction)};
  const double arriving = density * transmittance(segment, way.length) / (way.length * way.length);
  return {arriving * emission, direction_pdf * arriving, scene_.emission.pdf(density, emission)};
}

glm::dvec3 PathTracer::direct_light(const Vertex& vertex, PathRandom& random) const {
  const auto weight = [&](const PathLight& light, const glm::dvec3& point) {
    if (is_smooth(vertex) && light.area && !light.is_far) {
      const double pdf = light.direction_pdf(vertex.position, point);
      return pdf / (pdf + direction_pdf(vertex, glm::normalize(point - vertex.position)));
    }
    if (vertex.is_surface) return 1.0;
    return 1.0 - equi_angular_weight(light, glm::length(point - vertex.position));
  };
  return light_at(vertex, weight, random) + environment_at(vertex, random) +
         emitters_at(vertex, random);
}

glm::dvec3 PathTracer::lights_on_camera_ray(const CameraRay& ray, double opacity, double u,
                                            PathRandom& random) const {
  glm::dvec3 sum(0.0);
  const auto importance = [&](const PathLight& light) {
    const PointLightRay<double> path = relative_to(light, light.position, ray.eye(), ray.w());
    // The ray passes most of pi around a light nearby.
    const double span = !light.is_far ? pi : EquiAngular<double>(path, ray.visible_length()).span;
    const double size = light.area ? std::sqrt(facing_area(*light.area)) : 0.0;
    return max_component(light.intensity) * span / std::max(path.h, size);
  };
  choose_lights(importance, random, [&](const PathLight& light, double probability) {
    const AreaSampler::Point point = light.point(random);
    const PointLightRay<double> path = relative_to(light, point.position, ray.eye(), ray.w());
    const EquiAngular<double> angular(path, ray.visible_length());
    if (!(angular.span > 0.0)) return;
    const double t = std::min(angular.t(u * angular.span), ray.visible_length());
    const CameraRay::Point place = ray.at(t);
    const double scattered = place.density * std::exp(-place.depth);
    if (!(scattered > 0.0)) return;
    const Vertex vertex = Vertex::in_medium(ray.eye(), ray.w(), t);
    const auto [l, r, value] = arrival(vertex, point.position);
    const glm::dvec3 intensity = light.intensity_towards(point, vertex.position);
    if (!(r > 0.0) || !(max_component(intensity) > 0.0)) return;
    // The balance heuristic: divided by the sum of both densities.
    const double r2 = path.distance2(t);
    const double density = scattered / opacity + path.h / (angular.span * r2);
    const double factor =
        scattered * optics_at(vertex.position).albedo / (density * r2 * probability);
    sum += factor * visibility(vertex.position, light, point.position) * value * intensity;
  });
  return sum;
}

PathTracer::Segment PathTracer::segment(const Vertex& vertex, const glm::dvec3& w,
                                        PathRandom& random) const {
  const SurfaceHit hit = scene_.ray_caster.first_hit_by_chance(
      vertex.position, w, [&random] { return random.uniform(); });
  return {vertex.position, w, hit, scene_.fog.interval(vertex.position, w)};
}

glm::dvec3 PathTracer::light_on_segment(const PathLight& light, const Segment& segment,
                                        PathRandom& random) const {
  const glm::dvec3 none(0.0);
  const auto& [origin, w, hit, fog] = segment;
  // The farther the segment passes, the less often: equi_angular_weight() is as small there.
  const glm::dvec3 from_origin = light.position - origin;
  const double nearest = std::clamp(glm::dot(from_origin, w), 0.0, hit.distance);
  const glm::dvec3 offset = from_origin - nearest * w;
  const double near2 = light.near_radius * light.near_radius;
  const double probability = near2 / std::max(glm::dot(offset, offset), near2);
  if (random.uniform() >= probability) return none;

  const PointLightRay<double> path = relative_to(light, light.position, origin, w);
  const EquiAngular<double> angular(path, hit.distance);
  if (!(angular.span > 0.0)) return none;
  const double t = std::min(angular.t(random.uniform() * angular.span), hit.distance);
  const Vertex vertex = Vertex::in_medium(origin, w, t);
  const double density =
      scene_.medium.density(vertex.position) + (fog.contains(t) ? scene_.fog.density : 0.0);
  if (!(density > 0.0)) return none;
  const auto [l, r, value] = arrival(vertex, light.position);
  if (!(r > 0.0)) return none;
  const double scattered = density * optics_at(vertex.position).albedo * transmittance(segment, t);
  const double factor =
      scattered * equi_angular_weight(light, r) * angular.span / (path.h * probability);
  if (!(factor > 0.0)) return none;
  return factor * visibility(vertex.position, light, light.position) * value *
         light.intensity_along(-l);
}

PathTracer::AngularSampling::AngularSampling(const PathLight& light, const Vertex& vertex) {
  const glm::dvec3 q = light.position - vertex.position;
  const double distance = glm::length(q);
  if (!(distance > 0.0)) return;
  axis = q / distance;
  rate = std::min(1.0, light.near_radius / distance);
}

double PathTracer::AngularSampling::density(const glm::dvec3& w) const {
  if (!(rate > 0.0)) return 0.0;
  const double sine = std::max(glm::length(glm::cross(axis, w)), 1e-12);
  return rate / (2.0 * pi * pi * sine);
}

glm::dvec3 PathTracer::lights_around(const Vertex& vertex, PathRandom& random) const {
  glm::dvec3 sum(0.0);
  for (const PathLight& light : scene_.lights) {
    if (!(light.near_radius > 0.0)) continue;
    const AngularSampling sampling(light, vertex);
    if (random.uniform() >= sampling.rate) continue;
    const glm::dvec3 w = direction_around(sampling.axis, std::cos(pi * random.uniform()), random);
    const glm::dvec3 value = scattering(vertex, w);
    if (!(max_component(value) > 0.0)) continue;
    sum += value / (direction_pdf(vertex, w) + sampling.density(w)) *
           light_on_segment(light, segment(vertex, w, random), random);
  }
  return sum;
}

glm::dvec3 PathTracer::lights_along(const Vertex& vertex, const Segment& segment, double pdf,
                                    PathRandom& random) const {
  glm::dvec3 sum(0.0);
  for (const PathLight& light : scene_.lights) {
    if (!(light.near_radius > 0.0)) continue;
    const double other = AngularSampling(light, vertex).density(segment.w);
    sum += pdf / (pdf + other) * light_on_segment(light, segment, random);
  }
  return sum;
}

PathTracer::FirstCollision::FirstCollision(const CameraRay& camera_ray, double u)
    : ray(camera_ray),
      opacity(-std::expm1(-ray.depth())),
      point(ray.at_depth(-std::log1p(-opacity * u))),
      vertex(Vertex::in_medium(ray.eye(), ray.w(), point.t)),
      density(point.density * std::exp(-point.depth) / opacity) {}

double PathTracer::FirstCollision::weight(const PathLight& light,
                                          const glm::dvec3& light_point) const {
  const PointLightRay<double> path = relative_to(light, light_point, ray.eye(), ray.w());
  const EquiAngular<double> angular(path, ray.visible_length());
  if (!(angular.span > 0.0) || point.t > ray.visible_length()) return 1.0;
  return density / (density + path.h / (angular.span * path.distance2(point.t)));
}

OrderedRadiance PathTracer::airlight(const CameraRay& ray, const StratifiedPair& stratified,
                                     PathRandom& random) const {
  OrderedRadiance sum;
  const FirstCollision first(ray, stratified.first);
  const auto weight = [&first](const auto&... point) { return first.weight(point...); };
  const RelativeOptics optics = optics_at(first.vertex.position);
  const double scattered = first.opacity * optics.albedo;
  sum.add(1, first.opacity * optics.emission +
                 scattered *
                     (light_at(first.vertex, weight, random) +
                      environment_at(first.vertex, random) + emitters_at(first.vertex, random)) +
                 lights_on_camera_ray(ray, first.opacity, stratified.second, random));
  walk(first.vertex, glm::dvec3(scattered), random, sum);
  return sum;
}

glm::dvec3 PathTracer::lights_once(const CameraRay& ray, const StratifiedPair& stratified,
                                   PathRandom& random) const {
  const FirstCollision first(ray, stratified.first);
  const auto weight = [&first](const auto&... point) { return first.weight(point...); };
  return first.opacity * optics_at(first.vertex.position).albedo *
             (light_at(first.vertex, weight, random) + emitters_at(first.vertex, random) +
              emitters_around(first.vertex, random)) +
         lights_on_camera_ray(ray, first.opacity, stratified.second, random);
}

OrderedRadiance PathTracer::surface(const SurfacePoint& point, PathRandom& random) const {
  OrderedRadiance sum;
  Vertex vertex = Vertex::on_surface(point);
  vertex.is_view = scene_.light_shapes != nullptr;
  if (scene_.is_mirrored_alone) {
    if (!is_smooth(vertex)) return sum;
    vertex.is_mirror = true;
    vertex.point.ggx->diffuse = glm::dvec3(0.0);
    sum.add(1, environment_at(vertex, random) + emitters_at(vertex, random));
  } else {
    sum.add(1, point.emitted + direct_light(vertex, random));
  }
  walk(vertex, glm::dvec3(1.0), random, sum);
  return sum;
}

void PathTracer::walk(Vertex vertex, glm::dvec3 throughput, PathRandom& random,
                      OrderedRadiance& sum) const {
  const double full = max_component(throughput);
  double importance = 1.0;
  for (int events = 1;; ++events) {
    if (events >= first_roulette) {
      const double growth = max_component(throughput) / full;
      if (growth < 1.0) {
        if (random.uniform() >= growth) return;
        throughput /= growth;
      }
      if (growth > max_growth) return;
    }
    if (events >= long_path) {
      constexpr double survival = 1.0 - 1.0 / long_path;
      if (random.uniform() >= survival) return;
      throughput /= survival;
    }
    sum.add(events + 1, scene_.albedo * throughput *
                            (lights_around(vertex, random) + emission_at(vertex, random)));
    const Direction direction = sample_direction(vertex, random);
    if (!(direction.pdf > 0.0)) return;
    if (vertex.is_surface) {
      throughput *= scattering(vertex, direction.w) / direction.pdf;
      if (!(max_component(throughput) > 0.0)) return;
    }
    Segment next = segment(vertex, direction.w, random);
    const bool is_view = vertex.is_view && is_smooth(vertex);
    if (is_view) throughput *= end_at_light(vertex, next, random);
    const auto& [origin, w, hit, fog] = next;
    sum.add(events + 1,
            scene_.albedo * throughput * lights_along(vertex, next, direction.pdf, random));

    double in_fog = infinity;
    if (scene_.fog.density > 0.0) {
      const double t = fog.begin - std::log(random.uniform()) / scene_.fog.density;
      if (t < fog.end) in_fog = t;
    }
    const double end = std::min(hit.distance, in_fog);
    const double t = std::min(scene_.medium.collision(origin, w, end, random), in_fog);
    sum.add(events, throughput * lights_passed(vertex, direction, std::min(t, hit.distance)));
    if (t < hit.distance) {
      vertex = Vertex::in_medium(origin, w, t);
      throughput *= scene_.albedo;
      if (t < in_fog) {  // among the Gaussians
        const RelativeOptics optics = scene_.medium.index().optics_at(vertex.position, 0.0);
        if (optics.emission != glm::dvec3(0.0)) {
          const double weight = emission_of({origin, w, t}, direction.pdf).weight();
          sum.add(events + 1, weight * throughput * optics.emission);
        }
        throughput *= optics.albedo;
      }
      const double now = scene_.fog.importance(vertex.position);
      if (now < importance) {
        if (random.uniform() >= now / importance) return;
        throughput *= importance / now;
        importance = now;
      }
    } else if (hit.is_light()) {
      return;
    } else if (hit) {
      vertex = Vertex::on_surface(scene_.ray_caster.point(hit, origin, w, scene_.surfaces));
      vertex.is_view = is_view;
      throughput *= scene_.ray_caster.reflected_by_chance(hit);
      sum.add(events, throughput * emitted_by(hit, vertex.point, direction));
    } else {
      if (!scene_.environment) return;
      const double pdf = scene_.environment->pdf(w);
      sum.add(events,
              direction.pdf / (direction.pdf + pdf) * throughput * scene_.environment->radiance(w));
      return;
    }
    sum.add(events + 1, throughput * direct_light(vertex, random));
  }
}

}  // namespace brume
