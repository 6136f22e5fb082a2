#include "core/scene/materials/measured_brdf.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace brume {
namespace {

struct HalfAngles {
  double theta_h = 0.0;  // [0, pi/2]
  double theta_d = 0.0;  // [0, pi/2]
  double phi_d = 0.0;    // [0, pi)
};

HalfAngles half_angles(const glm::dvec3& wi, const glm::dvec3& wo, const glm::dvec3& n) {
  const glm::dvec3 sum = wi + wo;
  const double length = glm::length(sum);
  if (!(length > 0.0)) return {};
  const glm::dvec3 h = sum / length;
  // Angles from sine and cosine: acos loses half its digits where highlights are.
  const double half_pi = 0.5 * std::numbers::pi;
  HalfAngles angles;
  angles.theta_h =
      std::clamp(std::atan2(glm::length(glm::cross(n, h)), glm::dot(n, h)), 0.0, half_pi);
  angles.theta_d = std::min(std::atan2(0.5 * glm::length(wi - wo), 0.5 * length), half_pi);
  // Azimuth around h, from the side that leans away from the normal.
  const glm::dvec3 x = glm::dot(n, h) * h - n;
  const glm::dvec3 y = glm::cross(h, x);
  angles.phi_d = std::atan2(glm::dot(wi, y), glm::dot(wi, x));
  if (angles.phi_d < 0.0) angles.phi_d += std::numbers::pi;
  return angles;
}

// The two cells whose middles lie around a position in [0, cells], and the weight of the second.
struct Between {
  std::array<int, 2> cell;
  double weight;

  Between(double position, int cells, bool closes_around) {
    const double below = std::floor(position - 0.5);
    weight = position - 0.5 - below;
    for (int k = 0; k < 2; ++k) {
      const int i = static_cast<int>(below) + k;
      cell[static_cast<std::size_t>(k)] =
          closes_around ? (i + cells) % cells : std::clamp(i, 0, cells - 1);
    }
  }
};

}  // namespace

MeasuredBrdf::MeasuredBrdf(std::vector<glm::vec3> values) : values_(std::move(values)) {
  assert(values_.size() == samples);
}

glm::dvec3 MeasuredBrdf::operator()(const glm::dvec3& wi, const glm::dvec3& wo,
                                    const glm::dvec3& n) const {
  const HalfAngles angles = half_angles(wi, wo, n);
  const double half_pi = 0.5 * std::numbers::pi;
  const Between h(std::sqrt(angles.theta_h / half_pi) * theta_h_cells, theta_h_cells, false);
  const Between d(angles.theta_d / half_pi * theta_d_cells, theta_d_cells, false);
  const Between p(angles.phi_d / std::numbers::pi * phi_d_cells, phi_d_cells, true);
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const std::size_t i = corner & 1u;
    const std::size_t j = corner >> 1 & 1u;
    const std::size_t k = corner >> 2;
    const glm::vec3& value = values_[static_cast<std::size_t>(
        (h.cell[i] * theta_d_cells + d.cell[j]) * phi_d_cells + p.cell[k])];
    if (value.x < 0.0f || value.y < 0.0f || value.z < 0.0f) continue;
    const double weight = (i == 1 ? h.weight : 1.0 - h.weight) *
                          (j == 1 ? d.weight : 1.0 - d.weight) *
                          (k == 1 ? p.weight : 1.0 - p.weight);
    sum += weight * glm::dvec3(value);
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : glm::dvec3(0.0);
}

}  // namespace brume
