#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// The centripetal Catmull-Rom curve through points, from the first to the last, sampled at most
// about `spacing` > 0 apart [u]; at its ends tangent to the line between two points. Points at the
// place of the one before are passed over. A single point is itself.
std::vector<glm::dvec3> sample_spline(std::span<const glm::dvec3> points, double spacing);

}  // namespace brume
