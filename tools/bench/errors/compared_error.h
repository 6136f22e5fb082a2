#pragma once

#include <optional>
#include <string>

#include "render/quality/error_estimate.h"

namespace brume {

// How wrong something is, beside another way to do it.
struct ComparedError {
  std::string label;
  ErrorEstimate error;
  std::optional<ErrorEstimate> other;
};

}  // namespace brume
