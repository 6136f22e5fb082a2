#pragma once

#include <QString>
#include <glm/vec3.hpp>
#include <optional>

#include "app/commands/merge_id.h"
#include "brume/scene.h"

namespace brume {

class Document;

// Edits of emitters, each one undo step. `index`: of the scene's emitters.

// An emitter that suits a view `size` u wide, of another seed than those of the scene.
Emitter new_emitter(const Scene& scene, const glm::dvec3& position, double size);
// Adds an emitter sized for a view `size` u wide, which becomes the document's object. It can be
// adjusted as the last operation.
void add_emitter(Document& document, const glm::dvec3& position, double size);
// The radius of its particles at birth [u].
inline double born_radius(double size) {
  return 0.02 * size;
}
// Its name in undo texts, or else "emitter 2".
QString emitter_name(const Emitter& emitter, std::size_t index);

// When an emitter emits [s]: from `start` on, until `end` if there is one. It is in the keyframes
// of its rate, which is 0 before and after.
struct EmissionSpan {
  double start = 0.0;
  std::optional<double> end{};
};
EmissionSpan emission_span(const Emitter& emitter);
// Moves the keyframes at its ends, or makes or removes them.
void set_emission_span(Emitter& emitter, const EmissionSpan& span);

// Converts particles and sequences at a time [s] to Gaussians of the medium; emitters and sequences
// stay.
void freeze_particles(Document& document, double time);

}  // namespace brume
