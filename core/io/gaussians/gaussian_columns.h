#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/number_domain.h"

namespace brume::gaussian_columns {

// Column names of a Gaussian's attributes in files, in the order of Gaussian, and their domains.
inline constexpr std::array<std::string_view, 5> names{"x", "y", "z", "radius", "density"};
inline constexpr std::array<const NumberDomain*, 5> domains{
    &domain::coordinate, &domain::coordinate, &domain::coordinate, &domain::length,
    &domain::density};

// Alternative names: Houdini, CloudCompare. Read only.
inline constexpr std::array<std::array<std::string_view, 2>, 5> other_names{
    {{}, {}, {}, {"pscale", "scalar_radius"}, {"scalar_density", ""}}};

// Persistent id of a Gaussian in a sequence; an integer.
inline constexpr std::string_view id_name = "id";
inline constexpr NumberDomain id_domain{0.0, 4294967295.0, "an integer from 0 to 4294967295"};
constexpr bool is_id(double value) {
  return id_domain.contains(value) &&
         value == static_cast<double>(static_cast<std::uint32_t>(value));
}

// The allowed number of Gaussians of a file, for messages.
inline std::string allowed_count(std::size_t max_count) {
  return "at most " + std::to_string(max_count) +
         (max_count < limits::gaussians ? " in addition to the other Gaussians of the scene" : "");
}

// Calls find() with the name of column i, then its alternatives, until one yields a value.
template <class Find>
auto find_column(std::size_t i, Find find) {
  auto found = find(names[i]);
  for (const std::string_view name : other_names[i]) {
    if (!found && !name.empty()) found = find(name);
  }
  return found;
}

}  // namespace brume::gaussian_columns
