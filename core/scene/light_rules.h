#pragma once

#include <optional>
#include <string>

#include "brume/lights.h"

namespace brume {

// The member of a light that is not allowed beside the others, each in its domain, and why. Values
// with keyframes count for nothing: they are those of the moment at which a scene was saved.
struct RefusedLight {
  const char* member;
  std::string message;
};
std::optional<RefusedLight> refusal(const Light& light);

}  // namespace brume
