#pragma once

#include <optional>

#include "brume/medium.h"

namespace brume {

// Level of detail: of a medium of many small Gaussians that overlap, one of fewer with an error of
// optical depth up to `max_error`, see simplify(). nullopt: not so much fewer that frames would be
// faster.
std::optional<Medium> merged_medium(const Medium& medium, double max_error);

}  // namespace brume
