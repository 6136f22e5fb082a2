#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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

// Gaussians of a sequence keep this number from frame to frame; whole.
inline constexpr std::string_view id_name = "id";
inline constexpr NumberDomain id_domain{0.0, 4294967295.0, "a whole number from 0 to 4294967295"};
constexpr bool is_id(double value) {
  return id_domain.contains(value) &&
         value == static_cast<double>(static_cast<std::uint32_t>(value));
}

// How many Gaussians a file may have, in words.
inline std::string allowed_count(std::size_t max_count) {
  return "at most " + std::to_string(max_count) +
         (max_count < limits::gaussians ? " beside the others of the scene" : "");
}

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
