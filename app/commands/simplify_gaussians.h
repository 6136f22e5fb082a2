#pragma once

#include <span>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

class Document;
struct Simplified;

// The selected Gaussians, or all that are neither hidden nor locked.
std::vector<GaussianId> to_simplify(const Document& document);

// Replaces these Gaussians by simplify()'s, as one undo step.
void apply_simplified(Document& document, std::span<const GaussianId> ids,
                      const Simplified& simplified);

}  // namespace brume
