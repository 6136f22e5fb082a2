#pragma once

#include <QString>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "app/commands/merge_id.h"
#include "core/scene/far_lights.h"
#include "core/scene/scene.h"

namespace brume {

class Document;

// Edits of lights, each one undo step. `index`: of the scene's lights.
void add_light(Document& document, const glm::dvec3& position);
// Shines towards `target`.
void add_spot(Document& document, const glm::dvec3& position, const glm::dvec3& target);
// A sun: from above, behind the left shoulder of who looks along `view`.
void add_directional(Document& document, const glm::dvec3& view);
void delete_light(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the light's name.
void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(Light&)>& change);
QString light_name(std::size_t index);                       // "light 2"
QString light_title(const Light& light, std::size_t index);  // "Spot 2"
QString light_unit(const Light& light);                      // of its strength

enum class LightType { point, spot, directional };
LightType type_of(const Light& light);
// Keeps its strength at the middle of the region, and where it shines as far as the type has that.
void set_type(Light& light, LightType type, const LitRegion& region);

// The way a light shines; a point light has none.
std::optional<glm::dvec3> light_direction(const Light& light);
void turn(Light& light, const glm::dvec3& direction);

// Cones with an angle from the axis changed [degrees]; the other one makes room.
SpotCone with_inner_angle(SpotCone cone, double angle);
SpotCone with_outer_angle(SpotCone cone, double angle);

// Where a light is drawn: a directional light, which is nowhere, beside the middle of the scene.
glm::dvec3 handle_position(const Light& light, const LitRegion& region);

// Intensity = strength [W/sr or W/u^2] * colour, whose maximum channel is 1; white if zero.
double light_strength(const Light& light);
glm::dvec3 light_color(const Light& light);

}  // namespace brume
