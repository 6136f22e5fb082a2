#pragma once

#include <QString>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "app/commands/merge_id.h"
#include "brume/scene.h"
#include "core/scene/lights/point_lights.h"

namespace brume {

class Document;

// Where a light is added: at `position`, shining towards `target`, seen from `eye`.
struct LightPlace {
  glm::dvec3 position{0.0};
  glm::dvec3 target{0.0};
  glm::dvec3 eye{0.0};
};

// Edits of lights, each one undo step. `index`: of the scene's lights.
// Directional: a sun from above, behind the left shoulder of who looks at the target. An area light
// is a tenth as large as the target is far. A light of the kind, its other values are chosen.
void add_light(Document& document, const Light::Kind& kind, const LightPlace& place);

// Lights of everyday, as bright as suits a scene lit by 20 W/sr.
struct LightPreset {
  const char* name;  // of its action
  const char* title;
  Light::Kind kind;    // but for its direction
  double temperature;  // of its colour [K]
  double strength;     // [W/sr or W/u^2], of an area light [W/(sr u^2)]
};
std::span<const LightPreset> light_presets();
void add_preset(Document& document, const LightPreset& preset, const LightPlace& place);
// A light for contents within `radius` of `center`: outside them, from above, behind the left
// shoulder of an eye. White diffuse surfaces at the center that face it have a radiance of 1, which
// is as bright as pictures get without a change of exposure: the intensity is pi distance^2.
Light light_outside(const glm::dvec3& center, double radius, const glm::dvec3& eye);
// Its name in undo texts, or else "light 2".
QString light_name(const Light& light, std::size_t index);
QString light_unit(const Light& light);  // of its strength

// Keeps its strength at the middle of the region, and the values that both kinds have.
void set_kind(Light& light, const Light::Kind& kind, const LitRegion& region);
// Multiplies the lengths of its surface.
void scale(Light& light, double factor);

// The way a light shines; a point light has none.
std::optional<glm::dvec3> light_direction(const Light& light);
void turn(Light& light, const glm::dvec3& direction);

// The view from where a light is, along where it shines, or else at `target`; as wide as its cone.
Camera camera_at(const Light& light, const LitRegion& region, const glm::dvec3& target);

// Gives a point light or a spot a photometric profile, or with no content none.
void set_profile(Light& light, LightProfile profile);
// Puts a picture into the beam of a spot, or with no file none.
void set_texture(Light& light, LightTexture texture);

// Cones with an angle from the axis changed [degrees]; the other one makes room.
light::Spot with_inner_angle(light::Spot spot, double angle);
light::Spot with_outer_angle(light::Spot spot, double angle);

// Intensity = strength (see light_unit) * colour, whose maximum channel is 1; white if zero.
double light_strength(const Light& light);
glm::dvec3 light_color(const Light& light);

}  // namespace brume
