#pragma once

#include <QString>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "app/commands/merge_id.h"
#include "core/scene/far_lights.h"
#include "core/scene/scene.h"

namespace brume {

class Document;

enum class LightType { point, spot, directional };

// Edits of lights, each one undo step. `index`: of the scene's lights.
void add_light(Document& document, const glm::dvec3& position);
// Shines towards `target`.
void add_spot(Document& document, const glm::dvec3& position, const glm::dvec3& target);
// A sun: from above, behind the left shoulder of who looks along `view`.
void add_directional(Document& document, const glm::dvec3& view);

// Lights of everyday, as bright as suits a scene lit by 20 W/sr.
struct LightPreset {
  const char* name;  // of its action
  const char* title;
  LightType type;
  double temperature;                           // of its colour [K]
  double strength;                              // [W/sr or W/u^2]
  double inner_angle = 0.0, outer_angle = 0.0;  // of a spot [degrees]
  double angular_diameter = 0.0;                // of a directional light [degrees]
};
std::span<const LightPreset> light_presets();
// A spot or point light at `position`, a spot shining at `target`; a directional light from above
// who looks from `eye` to `target`.
void add_preset(Document& document, const LightPreset& preset, const glm::dvec3& position,
                const glm::dvec3& target, const glm::dvec3& eye);
void delete_light(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the light's name.
void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(Light&)>& change);
QString light_name(std::size_t index);                       // "light 2"
QString light_title(const Light& light, std::size_t index);  // "Spot 2"
QString light_unit(const Light& light);                      // of its strength

LightType type_of(const Light& light);
// Keeps its strength at the middle of the region, and where it shines as far as the type has that.
void set_type(Light& light, LightType type, const LitRegion& region);

// The way a light shines; a point light has none.
std::optional<glm::dvec3> light_direction(const Light& light);
void turn(Light& light, const glm::dvec3& direction);

// Cones with an angle from the axis changed [degrees]; the other one makes room.
SpotCone with_inner_angle(SpotCone cone, double angle);
SpotCone with_outer_angle(SpotCone cone, double angle);

// Where a light is drawn: a directional light, which is nowhere, beside what the scene's camera
// looks at, as near as an eye that looks there sees it.
glm::dvec3 handle_position(const Light& light, const Scene& scene, const glm::dvec3& eye);

// Intensity = strength [W/sr or W/u^2] * colour, whose maximum channel is 1; white if zero.
double light_strength(const Light& light);
glm::dvec3 light_color(const Light& light);

}  // namespace brume
