#pragma once

#include <QString>
#include <glm/vec3.hpp>

#include "app/commands/merge_id.h"
#include "brume/scene.h"

namespace brume {

class Document;

// The text for an environment: the name of its file, or "Sky".
QString environment_text(const Environment& environment);

// Puts a sky in place of the environment map, one undo step. Without an environment before, so
// bright that a white floor under it has a radiance of about 1, as pictures are exposed.
void add_sky(Document& document);

// Turns the sky's sun to a unit direction, an undo step that merges within a gesture.
void move_sun(Document& document, const glm::dvec3& direction, MergeId gesture);
// Puts back what it was before such a gesture.
void put_back_environment(Document& document, const Environment& environment, MergeId gesture);

}  // namespace brume
