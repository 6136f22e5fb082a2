#pragma once

#include <string>

#include "core/scene/fields/field.h"

namespace brume {

// The text of the manual and Python about a value: "Radius of the lens [u]; a number >= 0".
template <class F>
std::string description(const F& field) {
  const std::string unit = field.info.unit;
  std::string allowed = field.domain.allowed;
  const bool is_unit_said = unit.size() > 1 && allowed.find(unit) != std::string::npos;
  if (components < typename F::Value >> 1) allowed = "each " + allowed;
  std::string text = field.info.says;
  if (!unit.empty() && !is_unit_said) text += " [" + unit + "]";
  return text + "; " + allowed;
}

// The message for a value that is given beside one that it replaces.
inline std::string found_beside(const std::string& replaced) {
  return "found beside " + replaced + "; allowed: one of the two";
}

}  // namespace brume
