#pragma once

#include <QString>
#include <glm/vec3.hpp>
#include <optional>

#include "app/commands/merge_id.h"
#include "brume/scene.h"
#include "core/number_domain.h"

namespace brume {

class Document;

// Edits of emitters, each one undo step. `index` counts the scene's emitters.

// An emitter that suits a view `size` u wide, of another seed than those of the scene.
Emitter new_emitter(const Scene& scene, const glm::dvec3& position, double size);
// Adds an emitter sized for a view `size` u wide, which becomes the document's object. It can be
// adjusted as the last operation.
void add_emitter(Document& document, const glm::dvec3& position, double size);
// The radius of the particles at birth of an emitter sized for a view `size` u wide [u].
inline double born_radius(double size) {
  return 0.02 * size;
}
// The name of an emitter in undo texts, or else "emitter 2".
QString emitter_name(const Emitter& emitter, std::size_t index);

// An emitter emits from `start` on [s], until `end` if there is one. Keyframes of its rate hold
// that: steps from 0 to one rate and back to 0.
struct EmissionSpan {
  double start = 0.0;
  std::optional<double> end{};

  bool operator==(const EmissionSpan&) const = default;
};
// Starts and ends are at least a second before the last time that keyframes may have.
inline constexpr NumberDomain emission_time{0.0, domain::seconds.max_value - 1.0,
                                            "a number of seconds from 0 to 999999999"};
// The span of an emitter; nullopt if its rate is 0 or has other keyframes.
std::optional<EmissionSpan> emission_span(const Emitter& emitter);
// Replaces the span, its times by the nearest that are allowed. An emitter without one stays as it
// is.
void set_emission_span(Emitter& emitter, EmissionSpan span);

// Converts particles and sequences at a time [s] to Gaussians of the medium; emitters and sequences
// stay.
void freeze_particles(Document& document, double time);

}  // namespace brume
