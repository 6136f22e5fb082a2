#pragma once

#include <optional>
#include <string>

#include "render/quality/error_estimate.h"

namespace brume {

// The error of a method compared with that of another.
struct ComparedError {
  std::string label;
  ErrorEstimate error;
  std::optional<ErrorEstimate> other;
};

}  // namespace brume
