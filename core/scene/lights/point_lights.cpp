#include "core/scene/lights/point_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "brume/mesh_arrays.h"
#include "core/math/basis.h"
#include "core/math/golden_angle.h"
#include "core/math/infinity.h"
#include "core/math/substantial.h"
#include "core/math/unit_direction.h"
#include "core/overloaded.h"
#include "core/scene/lights/emitting_surfaces.h"

namespace brume {
namespace {

// Evenly over the unit disc (Vogel's spiral).
glm::dvec2 disc_point(int k, int count) {
  const double radius = std::sqrt((k + 0.5) / count);
  const double turn = golden_angle * k;
  return {radius * std::cos(turn), radius * std::sin(turn)};
}

// For a share of the light's irradiance, in the unit direction.
PointLight far_light(const Light& light, double share, const glm::dvec3& direction,
                     const LitRegion& region) {
  const double distance = far_light_distance * region.diameter;
  PointLight far;
  far.position = region.center + distance * direction;
  // Single precision ends.
  far.intensity = glm::min(share * distance * distance * light.intensity, glm::dvec3(1e35));
  far.is_far = true;
  return far;
}

// The disc as one far away, of the same radiance everywhere.
PointLight far_disk(const Light& light, const light::Directional& sun, const LitRegion& region) {
  const glm::dvec3 axis = to_light(sun);
  PointLight far = far_light(light, 1.0, axis, region);
  const double half_angle = glm::radians(0.5 * sun.angular_diameter);
  if (!(half_angle > 0.0)) return far;
  far.area = light::Disk{.direction = -axis,
                         .radius = far_light_distance * region.diameter * std::tan(half_angle)};
  far.area_center = far.position;
  // Its edge is farther away than its middle.
  far.intensity /= std::cos(half_angle) * std::cos(half_angle);
  return far;
}

// A spot with a picture in its beam: one light, or one for each channel.
std::vector<PointLight> beams(const Light& light, const light::Spot& spot) {
  std::vector<PointLight> lights;
  for (const BeamPattern& pattern : beam_patterns(spot)) {
    lights.push_back({.position = light.position,
                      .intensity = pattern.factor * light.intensity,
                      .falloff = LightFalloff(spot, pattern)});
  }
  return lights;
}

// Directions of equal irradiance on what faces the disc: evenly over the disc of their sines.
std::vector<PointLight> points_on_disc(const Light& light, const light::Directional& sun, int count,
                                       const LitRegion& region) {
  const glm::dvec3 axis = to_light(sun);
  const double diameter = sun.angular_diameter;
  if (!(diameter > 0.0) || count == 1) return {far_light(light, 1.0, axis, region)};
  const auto [u, v] = make_basis(axis);
  const double edge = std::sin(glm::radians(0.5 * diameter));
  std::vector<PointLight> lights;
  for (int k = 0; k < count; ++k) {
    const glm::dvec2 sines = edge * disc_point(k, count);
    const double cosine = std::sqrt(1.0 - glm::dot(sines, sines));
    const glm::dvec3 direction = cosine * axis + sines.x * u + sines.y * v;
    lights.push_back(far_light(light, 1.0 / (count * cosine), direction, region));
  }
  return lights;
}

// The distance of a box from a point; 0 within.
double distance_to(const LitBounds& box, const glm::dvec3& p) {
  return glm::length(glm::max(glm::max(box.low - p, p - box.high), 0.0));
}

// Shares of the points that are needed from a distance on, in sizes of the light. Of 21 they are
// Fibonacci numbers, whose lattices are even. In steps, so that a count mostly stays while
// something is dragged.
struct PointShare {
  double distance;
  int count;
};
constexpr int whole = 21;
constexpr int whole_sphere = 34;  // half of its points face away
constexpr int many_points = 256;
constexpr std::array point_shares{PointShare{1.0, 13}, PointShare{1.5, 8}, PointShare{3.0, 5},
                                  PointShare{6.0, 1}};

int count_on(const AreaLight& area, const glm::dvec3& center, const LitRegion& region,
             int max_count) {
  if (!region.bounds) return max_count;
  constexpr int min_in_shadows = 13;    // each is seen in the shadows of surfaces
  constexpr double no_penumbra = 32.0;  // sizes away
  const double distance = distance_to(*region.bounds, center) / std::sqrt(facing_area(area));
  int count = max_count;
  for (const PointShare& share : point_shares) {
    if (distance > share.distance) count = max_count * share.count / whole;
  }
  if (distance > point_shares.back().distance) count = 1;
  const bool has_penumbra = region.has_surfaces && distance < no_penumbra;
  return std::max(count, has_penumbra ? std::min(min_in_shadows, max_count) : 1);
}

// The middles, relative to the light's, and the normals of equal shares of a surface.
struct SurfacePoint {
  glm::dvec3 offset;
  glm::dvec3 normal;
};
SurfacePoint point_on(const light::Sphere& sphere, int k, int count) {
  const double z = 1.0 - 2.0 * (k + 0.5) / count;
  const double sine = std::sqrt(1.0 - z * z);
  const glm::dvec3 normal(sine * std::cos(golden_angle * k), sine * std::sin(golden_angle * k), z);
  return {sphere.radius * normal, normal};
}
SurfacePoint point_on(const light::Disk& disk, int k, int count) {
  const glm::dvec3 normal = unit_direction(disk.direction, {0.0, -1.0, 0.0});
  const auto [u, v] = make_basis(normal);
  const glm::dvec2 offset = count > 1 ? disk.radius * disc_point(k, count) : glm::dvec2(0.0);
  return {offset.x * u + offset.y * v, normal};
}
SurfacePoint point_on(const light::Rectangle& rectangle, int k, int count) {
  // A lattice that no line meets in rows: its shadows have as many steps as it has points.
  constexpr double inverse_golden_ratio = 0.61803398874989484820;
  const double x = (k + 0.5) / count - 0.5;
  const double turns = inverse_golden_ratio * k + 0.5;
  const double y = turns - std::floor(turns) - 0.5 + (count > 1 ? 0.5 / count : 0.0);
  const auto [right, up] = rectangle_axes(rectangle);
  return {rectangle.width * x * right + rectangle.height * y * up,
          unit_direction(rectangle.direction, {0.0, -1.0, 0.0})};
}

// Outside it a sphere is, to the fourth order in radius / distance, what isotropic lights on a
// smaller one are: within 0.5% from 1.5 radii from its center on.
bool is_seen_from_afar(const light::Sphere& sphere, const glm::dvec3& center,
                       const LitRegion& region) {
  return region.bounds && distance_to(*region.bounds, center) > 1.5 * sphere.radius;
}

std::vector<PointLight> points_on_area(const Light& light, const AreaLight& area, int count,
                                       const LitRegion& region) {
  const double share = surface_area(area) / count;
  const double radius = std::sqrt(share / std::numbers::pi);
  const auto* sphere = std::get_if<light::Sphere>(&area);
  const bool is_isotropic =
      sphere && (count == 1 || is_seen_from_afar(*sphere, light.position, region));
  const double depth = count > 1 ? std::sqrt(0.75) : 0.0;
  std::vector<PointLight> lights;
  for (int k = 0; k < count; ++k) {
    const auto [offset, normal] =
        std::visit([&](const auto& shape) { return point_on(shape, k, count); }, area);
    PointLight point{.radius = radius,
                     .area = area,
                     .area_center = light.position,
                     .area_points = count,
                     .index = k};
    if (is_isotropic) {
      point.position = light.position + depth * offset;
      point.intensity = 0.25 * share * light.intensity;
    } else {
      point.position = light.position + offset;
      point.intensity = share * light.intensity;
      point.falloff = LightFalloff::of_surface(normal, is_two_sided(area));
    }
    lights.push_back(point);
  }
  return lights;
}

}  // namespace

std::optional<LitBounds> lit_bounds(const Scene& scene) {
  LitBounds bounds{glm::dvec3(infinity), glm::dvec3(-infinity)};
  const auto add = [&](const glm::dvec3& p, double radius) {
    bounds.low = glm::min(bounds.low, p - radius);
    bounds.high = glm::max(bounds.high, p + radius);
  };
  std::vector<GaussianExtent> gaussians;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const Gaussian g = scene.medium.gaussian(i);
    gaussians.push_back({g.center - 3.0 * g.radius, g.center + 3.0 * g.radius,
                         g.density * g.mean_radius() * std::sqrt(std::numbers::pi),
                         g.optics.emission != glm::dvec3(0.0)});
  }
  for (const std::size_t i : substantial_gaussians(gaussians)) {
    add(gaussians[i].low, 0.0);
    add(gaussians[i].high, 0.0);
  }
  for (const Surface& surface : scene.surfaces) {
    const MeshBox box = world_box(surface);
    add(box.low, 0.0);
    add(box.high, 0.0);
  }
  return bounds.low.x <= bounds.high.x ? std::optional(bounds) : std::nullopt;
}

LitRegion LitRegion::of(const Scene& scene) {
  const double b0 = scene.medium.homogeneous_density();
  LitRegion region;
  double length = b0 > 0.0 ? 2.0 / b0 : region.diameter;
  const auto bounds = lit_bounds(scene);
  if (!(b0 > 0.0)) region.bounds = bounds;
  if (bounds) {
    region.center = 0.5 * (bounds->low + bounds->high);
    const double diagonal = glm::length(bounds->high - bounds->low);
    if (diagonal > 0.0) length = diagonal;
  }
  // At the end of a far larger ball of fog the light still comes from within a degree of its
  // direction; a farther one would leave too few digits to what is in the middle.
  if (b0 > 0.0 && scene.optics.extent) length = std::max(length, *scene.optics.extent / 32.0);
  region.has_surfaces = !scene.surfaces.empty();
  region.diameter = std::exp2(std::ceil(std::log2(length)));
  const double step = region.diameter / 16.0;
  region.center = step * glm::round(region.center / step);
  return region;
}

std::optional<AreaLight> area_of(const Light& light) {
  using Area = std::optional<AreaLight>;
  return std::visit(Overloaded{[](const light::Point&) { return Area(); },
                               [](const light::Spot&) { return Area(); },
                               [](const light::Directional&) { return Area(); },
                               [](const AreaLight& area) { return Area(area); }},
                    light.kind);
}

glm::dvec3 to_light(const light::Directional& light) {
  return -unit_direction(light.direction, {0.0, -1.0, 0.0});
}

bool is_two_sided(const AreaLight& area) {
  return std::visit([](const auto& shape) { return shape.two_sided; }, area);
}

bool is_visible(const AreaLight& area) {
  return std::visit([](const auto& shape) { return shape.visible; }, area);
}

bool is_seen(const Light& light) {
  const auto area = area_of(light);
  return light.on && area && is_visible(*area);
}

double surface_area(const AreaLight& area) {
  using std::numbers::pi;
  return std::visit(
      Overloaded{[](const light::Rectangle& r) { return r.width * r.height; },
                 [](const light::Disk& disk) { return pi * disk.radius * disk.radius; },
                 [](const light::Sphere& s) { return 4.0 * (pi * s.radius * s.radius); }},
      area);
}

double facing_area(const AreaLight& area) {
  return surface_area(area) * (std::holds_alternative<light::Sphere>(area) ? 0.25 : 1.0);
}

double area_of_point(const PointLight& point) {
  if (point.area_points == 0) return 0.0;
  return (point.falloff.is_isotropic() ? 0.25 : 1.0) * surface_area(*point.area) /
         point.area_points;
}

double bounding_radius(const AreaLight& area) {
  return std::visit(
      Overloaded{[](const light::Rectangle& r) { return 0.5 * std::hypot(r.width, r.height); },
                 [](const light::Disk& disk) { return disk.radius; },
                 [](const light::Sphere& sphere) { return sphere.radius; }},
      area);
}

std::pair<glm::dvec3, glm::dvec3> rectangle_axes(const light::Rectangle& area) {
  const glm::dvec3 normal = unit_direction(area.direction, {0.0, -1.0, 0.0});
  const glm::dvec3 right = glm::cross(normal, unit_direction(area.up, {0.0, 1.0, 0.0}));
  if (!(glm::length(right) > 1e-9)) {
    const auto [u, v] = make_basis(normal);
    return {u, v};
  }
  const glm::dvec3 unit = glm::normalize(right);
  return {unit, glm::cross(unit, normal)};
}

namespace {

// A light with a surface or a disc becomes at most `max_points`.
std::vector<PointLight> point_lights(const Light& light, const LitRegion& region, LightPoints count,
                                     int max_points) {
  using Points = std::vector<PointLight>;
  const auto chosen = [&](int few, int many) {
    const int points = count == LightPoints::one ? 1 : count == LightPoints::few ? few : many;
    return std::min(points, max_points);
  };
  const auto point = [&light](const auto& kind) {
    return Points{{light.position, light.intensity, LightFalloff(kind)}};
  };
  return std::visit(
      Overloaded{[&](const light::Point& kind) { return point(kind); },
                 [&](const light::Spot& kind) {
                   return kind.texture.content ? beams(light, kind) : point(kind);
                 },
                 [&](const light::Directional& sun) {
                   if (count == LightPoints::drawn) return Points{far_disk(light, sun, region)};
                   return points_on_disc(light, sun, chosen(8, 64), region);
                 },
                 [&](const AreaLight& area) {
                   if (count == LightPoints::drawn) {
                     return Points{{.position = light.position,
                                    .intensity = surface_area(area) * light.intensity,
                                    .area = area,
                                    .area_center = light.position,
                                    .area_points = 1}};
                   }
                   const bool is_sphere = std::holds_alternative<light::Sphere>(area);
                   const int points = chosen(is_sphere ? whole_sphere : whole, many_points);
                   return points_on_area(light, area,
                                         count_on(area, light.position, region, points), region);
                 }},
      light.kind);
}

}  // namespace

std::vector<PointLight> point_lights(const Light& light, const LitRegion& region,
                                     LightPoints count) {
  return point_lights(light, region, count, many_points);
}

std::vector<PointLight> point_lights(const Scene& scene, LightPoints count) {
  std::vector<const Light*> shining;
  for (const Light& light : scene.lights) {
    if (light.on && light.intensity != glm::dvec3(0.0)) shining.push_back(&light);
  }
  const bool needs_region = std::ranges::any_of(shining, [count](const Light* light) {
    return light->as<light::Directional>() || (area_of(*light) && count != LightPoints::one);
  });
  // Reads all vertices.
  const LitRegion region = needs_region ? LitRegion::of(scene) : LitRegion();
  // A sixth of a light's points for each surface that emits, up to 12 of them: with more, software
  // OpenGL ends its loops early.
  const int emitters =
      static_cast<int>(std::clamp<std::size_t>(emitter_count(scene.surfaces), 6, 12));
  // Fewer points for each where all of them would be too many; Fibonacci numbers, as above.
  std::vector<PointLight> lights;
  for (const int max_points : {whole_sphere, whole, 13, 8, 5, 3, 2, 1}) {
    lights.clear();
    for (const Light* light : shining) {
      const auto points =
          point_lights(*light, region, count, count == LightPoints::few ? max_points : many_points);
      lights.insert(lights.end(), points.begin(), points.end());
    }
    if (count != LightPoints::drawn) {
      const auto points =
          emitting_points(scene.surfaces, count == LightPoints::few    ? emitters * max_points / 6
                                          : count == LightPoints::many ? many_points
                                                                       : 1);
      lights.insert(lights.end(), points.begin(), points.end());
    }
    if (count != LightPoints::few || lights.size() <= max_few_points) break;
  }
  return lights;
}

}  // namespace brume
