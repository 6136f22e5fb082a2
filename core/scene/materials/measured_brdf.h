#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace brume {

// An isotropic measured BRDF as the MERL database tabulates it (Matusik et al., "A Data-Driven
// Reflectance Model", SIGGRAPH 2003): over the angle theta_h between normal and half vector, in
// cells that are narrow near 0, and over the polar and azimuthal angles theta_d and phi_d of the
// light around the half vector (Rusinkiewicz 1998).
class MeasuredBrdf {
 public:
  static constexpr int theta_h_cells = 90;  // cell i begins at theta_h = pi/2 (i / 90)^2
  static constexpr int theta_d_cells = 90;  // equal parts of [0, pi/2]
  static constexpr int phi_d_cells =
      180;  // equal parts of [0, pi]; by reciprocity there is no more
  static constexpr std::size_t samples = std::size_t{theta_h_cells} * theta_d_cells * phi_d_cells;

  // RGB [1/sr] for each cell, phi_d fastest, theta_h slowest; a negative value marks a cell that
  // was not measured.
  explicit MeasuredBrdf(std::vector<glm::vec3> values);

  // [1/sr], interpolated between the centers of measured cells; 0 if there is none around.
  // Directions are unit and point away from the surface.
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& wi, const glm::dvec3& wo,
                                      const glm::dvec3& n) const;

  [[nodiscard]] const std::vector<glm::vec3>& values() const { return values_; }

 private:
  std::vector<glm::vec3> values_;
};

}  // namespace brume
