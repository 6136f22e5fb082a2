#pragma once

#include <QString>
#include <functional>
#include <glm/vec3.hpp>

#include "app/commands/merge_id.h"
#include "brume/emitter.h"

namespace brume {

class Document;

// Edits of emitters, each one undo step. `index`: of the scene's emitters.

// Adds an emitter sized for a view `size` u wide.
void add_emitter(Document& document, const glm::dvec3& position, double size);
void delete_emitter(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the emitter's name.
void change_emitter(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Emitter&)>& change);
// Its name, or else "emitter 2", "Emitter 2".
QString emitter_name(const Emitter& emitter, std::size_t index);
QString emitter_title(const Emitter& emitter, std::size_t index);

// Converts particles and sequences at a time [s] to Gaussians of the medium; emitters and sequences
// stay.
void freeze_particles(Document& document, double time);

}  // namespace brume
