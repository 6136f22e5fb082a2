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

}  // namespace brume::gaussian_columns
