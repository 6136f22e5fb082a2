// The lights whose shapes smooth surfaces show to the paths of a view.

#include "core/scene/lights/area_lights.h"
#include "core/scene/lights/point_lights.h"
#include "render/paths/path_tracer.h"
#include "render/visibility/light_shapes.h"

namespace brume {

bool PathTracer::is_smooth(const Vertex& vertex) {
  return vertex.is_surface && vertex.point.ggx &&
         vertex.point.ggx->alpha < GgxReflection::max_mirror_alpha;
}

glm::dvec3 PathTracer::lights_passed(const Vertex& vertex, const Direction& direction,
                                     double length) const {
  glm::dvec3 sum(0.0);
  if (!is_smooth(vertex) || vertex.is_mirror) return sum;
  for (const PathLight& light : scene_.lights) {
    if (!light.area || light.is_far) continue;
    const auto hit = hit_area(*light.area, light.position, vertex.position, direction.w);
    if (!hit || hit->distance > length + light_margin(*hit, bounding_radius(*light.area))) {
      continue;
    }
    const double pdf =
        light.direction_pdf(vertex.position, vertex.position + hit->distance * direction.w);
    sum += direction.pdf / (direction.pdf + pdf) / surface_area(*light.area) * light.intensity;
  }
  return sum;
}

glm::dvec3 PathTracer::mirrored_share(const Vertex& vertex, const glm::dvec3& l) const {
  GgxReflection mirrored = *vertex.point.ggx;
  mirrored.diffuse = glm::dvec3(0.0);
  const glm::dvec3 part = ggx_brdf(mirrored, l, vertex.point.to_eye, vertex.point.normal);
  const glm::dvec3 all = brdf(vertex.point, l);
  glm::dvec3 share(1.0);
  for (int c = 0; c < 3; ++c) {
    if (all[c] > 0.0) share[c] = part[c] / all[c];
  }
  return share;
}

glm::dvec3 PathTracer::end_at_light(const Vertex& vertex, Segment& segment,
                                    PathRandom& random) const {
  SurfaceHit met = segment.hit;
  scene_.light_shapes->meet(segment.origin, segment.w, met);
  if (!met.is_light()) return glm::dvec3(1.0);
  const glm::dvec3 mirrored = mirrored_share(vertex, segment.w);
  const double chance = (mirrored.x + mirrored.y + mirrored.z) / 3.0;
  if (random.uniform() < chance) {
    segment.hit = met;
    return mirrored / chance;
  }
  return (1.0 - mirrored) / (1.0 - chance);
}

glm::dvec3 PathTracer::shapes_pass(const Vertex& vertex, const glm::dvec3& l,
                                   double distance) const {
  // A light does not hide itself.
  constexpr double nearer = 1.0 - 1e-3;
  if (!vertex.is_view || !is_smooth(vertex)) return glm::dvec3(1.0);
  SurfaceHit met{.distance = nearer * distance};
  scene_.light_shapes->meet(vertex.position, l, met);
  return met.is_light() ? 1.0 - mirrored_share(vertex, l) : glm::dvec3(1.0);
}

}  // namespace brume
