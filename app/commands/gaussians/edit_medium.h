#pragma once

#include <functional>
#include <span>

#include "app/commands/gaussians/medium_command.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/text/arithmetic.h"

namespace brume {

class Document;

// Edits of Gaussians, each one undo step; no effect beyond the Gaussian budget (gaussian_budget.h).

// Values are clamped to their domains. The Gaussian is in the active group.
void add_gaussian(Document& document, const Gaussian& gaussian);
// Adds and selects Gaussians. `verb` begins the undo text: "Paste 3 Gaussians".
void add_gaussians(Document& document, std::span<const Gaussian> gaussians, const QString& verb);
// Puts other Gaussians in place of some, as one undo step; if some of those were selected, the
// others are, beside what else is.
void replace_gaussians(Document& document, std::span<const GaussianId> removed,
                       std::span<const Gaussian> added, const QString& text);
void delete_selection(Document& document, const QString& verb);

void set_homogeneous_density(Document& document, double b0, MergeId merge_id);

// Sets one attribute of Gaussians. A value outside its domain changes nothing; returns the reason
// (empty: done).
QString set_attribute(Document& document, std::span<const GaussianId> ids, GaussianAttribute field,
                      double value, MergeId merge_id = no_merge);

// "Set radius of 3 Gaussians to 0.4".
QString set_attribute_text(GaussianAttribute field, std::size_t count, double value);

// Changes albedo or emission of Gaussians. The density follows the albedo, so that the mean
// extinction stays.
void change_optics(Document& document, std::span<const GaussianId> ids,
                   const std::function<void(GaussianOptics&)>& change, MergeId merge_id = no_merge);

// Changes one attribute of each Gaussian by what it is; values are clamped to their domains.
void adjust_attribute(Document& document, std::span<const GaussianId> ids, GaussianAttribute field,
                      const Adjustment& adjustment);

// Sets Gaussians ids[k] to after[k] within a gesture named `text`; values are clamped to their
// domains.
void change_gaussians(Document& document, std::span<const GaussianId> ids,
                      std::span<const Gaussian> after, const QString& text, MergeId merge_id);

}  // namespace brume
