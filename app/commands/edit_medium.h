#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "app/commands/medium_command.h"
#include "app/document/gaussian_field.h"

namespace brume {

class Document;

// What users do to Gaussians, each one undo step.

// Numbers outside the domains of their fields are brought to their limits.
void add_gaussian(Document& document, const Gaussian& gaussian);
void delete_selection(Document& document);

// Writes one number into Gaussians. A value outside the field's domain changes nothing; the answer
// then says why (empty: done).
QString set_field(Document& document, std::span<const GaussianId> ids, GaussianField field,
                  double value);

// Puts Gaussians at centers[k], as one move of a gesture; no further out than files may hold.
void move_gaussians(Document& document, std::span<const GaussianId> ids,
                    std::span<const glm::dvec3> centers, MergeId merge_id);

}  // namespace brume
