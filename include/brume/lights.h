#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "brume/keys.h"
#include "brume/object_id.h"

namespace brume {

class PhotometricProfile;
struct RadianceMap;

// ...Keys are the keyframes of an object's values; see core/scene/animation/animation.h.
struct LightKeys {
  Keys<glm::dvec3> position;
  Keys<glm::dvec3> intensity;
  Keys<glm::dvec3> direction;  // of all but a point light and a sphere
  // Of a spot.
  Keys<double> inner_angle;
  Keys<double> outer_angle;
  Keys<double> profile_rotation;
  Keys<double> angular_diameter;  // of a directional light
  // Of an area light.
  Keys<glm::dvec3> up;
  Keys<double> width;
  Keys<double> height;
  Keys<double> radius;

  bool operator==(const LightKeys&) const = default;
};

// The cone of a spot light: full intensity within the inner angle, none beyond the outer one; a
// hard edge where they are equal. See core/scene/lights/light_falloff.h.
struct SpotCone {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the way it shines; any length but 0
  double inner_angle = 0.0;              // from the axis, >= 0 [degrees]
  double outer_angle = 45.0;             // above 0, at least inner_angle, at most 180 [degrees]

  bool operator==(const SpotCone&) const = default;
};

// How a luminaire spreads the light of a point light, whose axis is straight down, or of a spot,
// within its cone; see core/scene/lights/light_falloff.h.
struct LightProfile {
  std::filesystem::path file;                         // IES LM-63
  std::shared_ptr<const PhotometricProfile> content;  // null: none
  double rotation = 0.0;  // about the axis, counterclockwise against it [degrees]

  bool operator==(const LightProfile&) const = default;
};

// How a directional light shines: the sun, or anything as far away. Methods evaluate it as
// core/scene/lights/point_lights.h has it.
struct Directional {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the way it shines; any length but 0
  double angular_diameter = 0.0;         // of its disc, in [0, 90) [degrees]

  bool operator==(const Directional&) const = default;
};

// A surface that shines with the same radiance everywhere and in all directions of its front, or of
// both sides. It is not seen itself and keeps no light out, as point lights.
struct AreaLight {
  enum class Shape { rectangle, disk, sphere };
  Shape shape = Shape::rectangle;
  glm::dvec3 direction{0.0, -1.0, 0.0};  // normal of its front; any length but 0; not of a sphere
  glm::dvec3 up{0.0, 1.0, 0.0};          // along the height of a rectangle, but for the normal
  double width = 1.0, height = 1.0;      // of a rectangle, > 0 [u]
  double radius = 0.5;                   // of a disk or sphere, > 0 [u]
  bool two_sided = false;                // a sphere then shines inwards, too

  bool operator==(const AreaLight&) const = default;
};

// A point light, a spot (a point light with a cone), a directional or an area light. Intensity,
// RGB, >= 0: of a point light radiant intensity [W/sr], of a spot that on its axis, with a profile
// that in its brightest direction, of a directional light irradiance on what faces it, without any
// medium [W/u^2], of an area light radiance [W/(sr u^2)].
struct Light {
  glm::dvec3 position{0.0};  // an area light's center; of no meaning for a directional light
  glm::dvec3 intensity{1.0};
  std::optional<SpotCone> spot{};  // at most one of these
  std::optional<Directional> directional{};
  std::optional<AreaLight> area{};
  LightProfile profile{};  // of a point light or a spot
  LightKeys keys{};
  std::string name{};  // empty: none of its own
  bool on = true;
  bool locked = false;  // for editors: not to be changed in the view
  ObjectId id = 0;

  bool operator==(const Light&) const = default;
};

struct EnvironmentKeys {
  Keys<double> intensity;
  Keys<double> rotation;

  bool operator==(const EnvironmentKeys&) const = default;
};

// An environment map; rotation about +y in degrees. Evaluated by core/scene/lights/environment.h.
struct Environment {
  std::filesystem::path file;
  std::shared_ptr<const RadianceMap> map;  // never null in a loaded scene
  double intensity = 1.0;
  double rotation = 0.0;
  EnvironmentKeys keys{};
  ObjectId id = 0;

  bool operator==(const Environment&) const = default;
};

}  // namespace brume
