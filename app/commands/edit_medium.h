#pragma once

#include <span>

#include "app/commands/medium_command.h"
#include "app/document/gaussian_field.h"

namespace brume {

class Document;

// What users do to Gaussians, each one undo step; nothing where there is no room for them
// (gaussian_budget.h).

// Numbers outside the domains of their fields are brought to their limits.
void add_gaussian(Document& document, const Gaussian& gaussian);
// They become the selection. `verb` begins the text of the step: "Paste 3 Gaussians".
void add_gaussians(Document& document, std::span<const Gaussian> gaussians, const QString& verb);
void delete_selection(Document& document, const QString& verb);

void set_homogeneous_density(Document& document, double b0, MergeId merge_id);

// Writes one number into Gaussians. A value outside the field's domain changes nothing; the answer
// then says why (empty: done).
QString set_field(Document& document, std::span<const GaussianId> ids, GaussianField field,
                  double value, MergeId merge_id = no_merge);

// Gives Gaussians other values, after[k] to ids[k], as one move of a gesture called `text`; numbers
// outside the domains of their fields are brought to their limits.
void change_gaussians(Document& document, std::span<const GaussianId> ids,
                      std::span<const Gaussian> after, const QString& text, MergeId merge_id);

}  // namespace brume
