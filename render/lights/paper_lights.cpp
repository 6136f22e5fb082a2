#include "render/lights/paper_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brume {

bool is_in_dense_gaussian(const MediumIndex& medium, const glm::dvec3& point) {
  constexpr double radii = 2.0;
  constexpr double dense = 3.0;  // optical depth of a line through the centre
  return std::any_of(medium.gaussians().begin(), medium.gaussians().end(), [&](const auto& g) {
    return g.c / g.a * std::sqrt(std::numbers::pi) > dense &&
           g.a * glm::length(g.b - point) < radii;
  });
}

}  // namespace brume
