#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// The first point at the place of each; -0 is 0.
std::vector<std::uint32_t> find_places(std::span<const glm::dvec3> points);

}  // namespace brume
