#include "render/lights/paper_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace brume {
namespace {

// Whether any dense Gaussian is near, by its distance.
bool is_near_dense_gaussian(const MediumIndex& medium, auto&& distance_to) {
  constexpr double radii = 2.0;
  constexpr double dense = 3.0;  // optical depth of a line through the centre
  return std::any_of(medium.gaussians().begin(), medium.gaussians().end(), [&](const auto& g) {
    return g.c / g.a * std::sqrt(std::numbers::pi) > dense && g.a * distance_to(g.b) < radii;
  });
}

}  // namespace

bool is_in_dense_gaussian(const MediumIndex& medium, const glm::dvec3& point) {
  return is_near_dense_gaussian(
      medium, [&point](const glm::dvec3& center) { return glm::length(center - point); });
}

bool starts_in_dense_gaussian(const MediumIndex& medium, const CameraRays& rays) {
  return is_near_dense_gaussian(
      medium, [&rays](const glm::dvec3& center) { return std::abs(rays.distance_to(center)); });
}

}  // namespace brume
