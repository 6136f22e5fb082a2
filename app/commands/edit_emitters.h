#pragma once

#include <QString>
#include <glm/vec3.hpp>

#include "app/commands/merge_id.h"
#include "brume/emitter.h"

namespace brume {

class Document;

// Edits of emitters, each one undo step. `index`: of the scene's emitters.

// Adds an emitter sized for a view `size` u wide, which becomes the document's object. It can be
// adjusted as the last operation.
void add_emitter(Document& document, const glm::dvec3& position, double size);
// The radius of its particles at birth [u].
inline double born_radius(double size) {
  return 0.02 * size;
}
// Its name in undo texts, or else "emitter 2".
QString emitter_name(const Emitter& emitter, std::size_t index);

// Converts particles and sequences at a time [s] to Gaussians of the medium; emitters and sequences
// stay.
void freeze_particles(Document& document, double time);

}  // namespace brume
