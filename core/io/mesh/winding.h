#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// Turns triangles round so that all that hang together by edges are wound alike, as most of them
// are (of half and half, as the first is). Triangles that lie on each other, and those beyond an
// edge of more than two, are turned to one side. `points` of the vertices; vertices with the same
// number in `places` are at one place. `ignored` triangles keep their winding.
void make_winding_consistent(const std::vector<glm::dvec3>& points,
                             std::span<const std::uint32_t> places,
                             const std::vector<bool>& ignored, std::span<glm::uvec3> triangles);

}  // namespace brume
