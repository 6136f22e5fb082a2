#pragma once

#include <array>
#include <string_view>

#include "core/io/number_domain.h"

namespace brume::gaussian_columns {

// What a Gaussian's numbers are called in files, in the order of Gaussian, and what they may be.
inline constexpr std::array<std::string_view, 5> names{"x", "y", "z", "radius", "density"};
inline constexpr std::array<const NumberDomain*, 5> domains{
    &domain::coordinate, &domain::coordinate, &domain::coordinate, &domain::length,
    &domain::density};

// What other programs call them: Houdini, CloudCompare. Read, never written.
inline constexpr std::array<std::array<std::string_view, 2>, 5> other_names{
    {{}, {}, {}, {"pscale", "scalar_radius"}, {"scalar_density", ""}}};

// find(name) for the name of number i, then for its other names, until that gives a value.
template <class Find>
auto find_column(std::size_t i, Find find) {
  auto found = find(names[i]);
  for (const std::string_view name : other_names[i]) {
    if (!found && !name.empty()) found = find(name);
  }
  return found;
}

}  // namespace brume::gaussian_columns
