#pragma once

#include <span>
#include <vector>

#include "app/commands/gaussians/operation_numbers.h"
#include "brume/medium.h"
#include "core/authoring/simplify.h"

namespace brume {

class Document;

// The selected Gaussians, or all that are neither hidden nor locked.
std::vector<GaussianId> to_simplify(const Document& document);

Medium chosen_gaussians(const Medium& medium, std::span<const GaussianId> ids);

SimplifyLimits limits_of(const SimplifyNumbers& numbers);

// Replaces these Gaussians by simplify()'s, as one undo step.
void apply_simplified(Document& document, std::span<const GaussianId> ids,
                      const Simplified& simplified);

}  // namespace brume
