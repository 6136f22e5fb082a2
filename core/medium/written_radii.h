#pragma once

#include <glm/vec3.hpp>

#include "brume/gaussian.h"

namespace brume {

// The radii of a Gaussian for files, which read them by Gaussian::set_radii(): the greatest exactly
// its radius, the others as they were given if 15 digits say so, and otherwise to a rounding.
glm::dvec3 written_radii(const Gaussian& gaussian);

}  // namespace brume
