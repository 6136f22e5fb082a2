#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "brume/keys.h"
#include "brume/object_id.h"

namespace brume {

class PhotometricProfile;
class Texture;
struct RadianceMap;

// Keyframes of a light's values, of those that its kind has; see core/scene/animation/animation.h.
struct LightKeys {
  Keys<glm::dvec3> position;
  Keys<glm::dvec3> intensity;
  Keys<glm::dvec3> direction;
  Keys<double> inner_angle;
  Keys<double> outer_angle;
  Keys<double> profile_rotation;
  Keys<double> texture_rotation;
  Keys<double> texture_focus;
  Keys<double> angular_diameter;
  Keys<glm::dvec3> up;
  Keys<double> width;
  Keys<double> height;
  Keys<double> radius;

  bool operator==(const LightKeys&) const = default;
};

// How a luminaire spreads the light of a point light, whose axis is straight down, or of a spot,
// within its cone; see core/scene/lights/light_falloff.h.
struct LightProfile {
  std::filesystem::path file;                         // IES LM-63
  std::shared_ptr<const PhotometricProfile> content;  // null: none
  double rotation = 0.0;  // about the axis, counterclockwise against it [degrees]

  bool operator==(const LightProfile&) const = default;
};

// A picture in the beam of a spot, a gobo: it fills the square around the outer cone, upright as
// seen from a spot that shines ahead; see core/scene/lights/beam_pattern.h.
struct LightTexture {
  std::filesystem::path file;              // empty: none
  std::shared_ptr<const Texture> content;  // null: none, or the file is missing
  double rotation = 0.0;  // about the axis, counterclockwise as seen from the light [degrees]
  double focus = 1.0;     // 1 sharp, 0 blurred to the size of the cone

  bool operator==(const LightTexture&) const = default;
};

// The kinds of lights: each has values of its own, in the order of Light::Kind.
namespace light {

// A point that shines alike in all directions, or as its profile says.
struct Point {
  LightProfile profile{};

  bool operator==(const Point&) const = default;
};

// A point that shines in a cone: full intensity within the inner angle, none beyond the outer one;
// a hard edge where they are equal. See core/scene/lights/light_falloff.h.
struct Spot {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the way it shines; any length but 0
  double inner_angle = 0.0;              // from the axis, >= 0 [degrees]
  double outer_angle = 45.0;             // above 0, at least inner_angle, at most 180 [degrees]
  LightProfile profile{};
  LightTexture texture{};  // with one, outer_angle is below 90

  bool operator==(const Spot&) const = default;
};

// The sun, or anything as far away. Methods evaluate it as core/scene/lights/point_lights.h has it.
struct Directional {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the way it shines; any length but 0
  double angular_diameter = 0.0;         // of its disc, in [0, 90) [degrees]

  bool operator==(const Directional&) const = default;
};

// Surfaces that shine with the same radiance everywhere and in all directions of their front, or of
// both sides. They keep no light out, as point lights. Where they are visible, view rays and those
// that smooth surfaces mirror end at the sides that shine.
struct Rectangle {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // normal of its front; any length but 0
  glm::dvec3 up{0.0, 1.0, 0.0};          // along its height, but for the normal
  double width = 1.0, height = 1.0;      // > 0 [u]
  bool two_sided = false;
  bool visible = false;

  bool operator==(const Rectangle&) const = default;
};

struct Disk {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // normal of its front; any length but 0
  double radius = 0.5;                   // > 0 [u]
  bool two_sided = false;
  bool visible = false;

  bool operator==(const Disk&) const = default;
};

struct Sphere {
  double radius = 0.5;     // > 0 [u]
  bool two_sided = false;  // it then shines inwards, too
  bool visible = false;

  bool operator==(const Sphere&) const = default;
};

}  // namespace light

// Intensity, RGB, >= 0: of a point light radiant intensity [W/sr], of a spot that on its axis, with
// a profile that in its brightest direction, of a directional light irradiance on what faces it,
// without any medium [W/u^2], of a surface radiance [W/(sr u^2)].
struct Light {
  using Kind = std::variant<light::Point, light::Spot, light::Directional, light::Rectangle,
                            light::Disk, light::Sphere>;

  glm::dvec3 position{0.0};  // a surface's center; of no meaning for a directional light
  glm::dvec3 intensity{1.0};
  Kind kind{};
  LightKeys keys{};
  std::string name{};  // empty: none of its own
  bool on = true;
  bool locked = false;  // for editors: not to be changed in the view
  ObjectId id = 0;

  // The values of a kind; null if it is of another.
  template <class K>
  [[nodiscard]] K* as() {
    return std::get_if<K>(&kind);
  }
  template <class K>
  [[nodiscard]] const K* as() const {
    return std::get_if<K>(&kind);
  }

  bool operator==(const Light&) const = default;
};

struct EnvironmentKeys {
  Keys<double> intensity;
  Keys<double> rotation;

  bool operator==(const EnvironmentKeys&) const = default;
};

struct SkyKeys {
  Keys<double> elevation;
  Keys<double> azimuth;
  Keys<double> turbidity;
  Keys<glm::dvec3> ground_albedo;

  bool operator==(const SkyKeys&) const = default;
};

// A clear sky, computed (core/scene/atmosphere). At a time of the scene it is a map, and its sun
// one of the lights; see evaluate_at().
struct Sky {
  double elevation = 30.0;        // of the sun's center above the horizon, in [-90, 90] [degrees]
  double azimuth = 0.0;           // of the sun: 0 is -z, 90 is +x [degrees]
  double turbidity = 3.0;         // in [1, 10]
  glm::dvec3 ground_albedo{0.3};  // RGB in [0, 1]
  bool sun = true;                // whether it comes with its directional light
  SkyKeys keys{};

  bool operator==(const Sky&) const = default;
};

// An environment map, or a sky in its place; rotation about +y in degrees. Evaluated by
// core/scene/lights/environment.h.
struct Environment {
  std::filesystem::path file;
  std::shared_ptr<const RadianceMap> map;  // never null in a loaded scene without a sky
  double intensity = 1.0;
  double rotation = 0.0;
  EnvironmentKeys keys{};
  ObjectId id = 0;
  std::optional<Sky> sky{};

  bool operator==(const Environment&) const = default;
};

}  // namespace brume
