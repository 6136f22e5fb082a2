#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "brume/medium.h"

namespace brume {

// Optical depth of the lines through Gaussians along three axes, at the resolution of a 128th of
// their bounds.
class AxisDepths {
 public:
  explicit AxisDepths(const Medium& medium);

  // One more of them, or less. Outside of the bounds of the first ones it counts at their border.
  void add(const Gaussian& gaussian) { add(gaussian, 1.0); }
  void remove(const Gaussian& gaussian) { add(gaussian, -1.0); }

  // The depth of the shallowest of the three lines through a point; outside of the bounds, of the
  // nearest.
  [[nodiscard]] double least(const glm::dvec3& x) const;

 private:
  [[nodiscard]] glm::ivec3 cell_of(const glm::dvec3& x) const;
  void add(const Gaussian& gaussian, double times);

  glm::dvec3 low_{0.0}, size_{1.0};
  std::array<std::vector<double>, 3> depths_;
};

}  // namespace brume
