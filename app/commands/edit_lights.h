#pragma once

#include <QString>
#include <functional>
#include <glm/vec3.hpp>

#include "app/commands/merge_id.h"
#include "core/scene/scene.h"

namespace brume {

class Document;

// Edits of lights, each one undo step. `index`: of the scene's lights.
void add_light(Document& document, const glm::dvec3& position);
// Shines towards `target`.
void add_spot(Document& document, const glm::dvec3& position, const glm::dvec3& target);
void delete_light(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the light's name.
void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(PointLight&)>& change);
QString light_name(std::size_t index);  // "light 2"

// Cones with an angle from the axis changed [degrees]; the other one makes room.
SpotCone with_inner_angle(SpotCone cone, double angle);
SpotCone with_outer_angle(SpotCone cone, double angle);

// Intensity = strength [W/sr] * colour, whose maximum channel is 1; white if zero.
double light_strength(const PointLight& light);
glm::dvec3 light_color(const PointLight& light);

}  // namespace brume
