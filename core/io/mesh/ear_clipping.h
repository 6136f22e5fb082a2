#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace brume {

// Twice the area of a triangle, > 0 if it is counterclockwise.
double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// Cuts a counterclockwise polygon into triangles of its corners. Where the outline turns back on
// itself, around no area, there are none. `tests` is what may be spent on looking for ears, and
// counts down to 0; from there on, the rest becomes a fan.
std::vector<std::array<std::uint32_t, 3>> clip_ears(std::span<const glm::dvec2> corners,
                                                    std::size_t& tests);

}  // namespace brume
