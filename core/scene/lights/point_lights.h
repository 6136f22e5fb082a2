#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "brume/limits.h"
#include "brume/scene.h"
#include "core/scene/lights/light_falloff.h"

namespace brume {

// Every light as point lights: what evaluates these evaluates them all. A directional light is one
// that is far away, an area light many that are spread over it.

// Lights that are surfaces.
using AreaLight = std::variant<light::Rectangle, light::Disk, light::Sphere>;
std::optional<AreaLight> area_of(const Light& light);

struct PointLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};  // RGB [W/sr]
  LightFalloff falloff{};
  double radius = 0.0;   // of a disk as large as what it stands for of an area light [u]
  bool is_far = false;   // stands for a directional light
  bool is_seen = false;  // stands for a surface that emits, which is seen
  // The area light that it stands for, and its middle: of surfaces that emit the rectangle that its
  // piece of them fills, if it does; null of a disc that is far away but for LightPoints::drawn.
  std::optional<AreaLight> area{};
  glm::dvec3 area_center{0.0};
  int area_points = 0;  // how many stand for it; they follow each other
  int index = 0;        // among those that stand for one area light, or for all that emits

  bool operator==(const PointLight&) const = default;
};

// Bounds of surfaces and of substantial_gaussians() (3 radii each); nullopt without any. Reads all
// vertices.
struct LitBounds {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
};
std::optional<LitBounds> lit_bounds(const Scene& scene);

// The region that lights shine on: surfaces and Gaussians (3 radii each), or else the fog within a
// mean free path of the origin. In coarse steps, so that it mostly stays while a medium is painted.
struct LitRegion {
  glm::dvec3 center{0.0};
  double diameter = 2.0;  // [u]
  // For area lights: of surfaces and Gaussians, exact; nullopt where fog is everywhere.
  std::optional<LitBounds> bounds{};
  bool has_surfaces = false;

  static LitRegion of(const Scene& scene);
};

// A far light is this many diameters of the region away. Over the region its irradiance differs by
// at most 0.06%, its direction by 0.016 degrees, in fog around it by twice as much; single
// precision still tells points in the region apart at a 4000th of it.
inline constexpr double far_light_distance = 2048.0;

// The unit direction towards it; straight up where keyframes pass length 0.
glm::dvec3 to_light(const light::Directional& light);

bool is_two_sided(const AreaLight& area);
bool is_visible(const AreaLight& area);
// Whether a light is on and its shape is visible.
bool is_seen(const Light& light);
// [u^2]; `facing`: as seen from far away, from where it looks largest.
double surface_area(const AreaLight& area);
double facing_area(const AreaLight& area);
// How much of an area light's surface, facing the way that it shines most, a point stands for; 0 of
// lights that are points [u^2].
double area_of_point(const PointLight& point);
// The radius of the ball around its center that holds it [u].
double bounding_radius(const AreaLight& area);
// Unit vectors along the width and the height of a rectangle.
std::pair<glm::dvec3, glm::dvec3> rectangle_axes(const light::Rectangle& rectangle);

// How many point lights stand for a light with a surface.
enum class LightPoints {
  one,
  few,    // for pictures; of a scene at most max_few_points
  many,   // for what pictures are held against
  drawn,  // one with an `area`, of which points are drawn at random; its intensity is in all
};

// The smallest maps of so many fit max_light_map_bytes, and there are no more lights.
inline constexpr std::size_t max_few_points = limits::lights;

// For a light, whether it is on or not, in a region that holds what it lights.
std::vector<PointLight> point_lights(const Light& light, const LitRegion& region,
                                     LightPoints count);

// The lights that are on and not black, in their order, then surfaces that emit, which
// LightPoints::drawn leaves out.
std::vector<PointLight> point_lights(const Scene& scene, LightPoints count = LightPoints::one);

}  // namespace brume
