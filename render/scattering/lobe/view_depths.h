#pragma once

#include <glm/vec3.hpp>

#include "render/geometry/fog_ball.h"
#include "render/scattering/source_grid.h"

namespace brume {

// A medium around surfaces, whose phase function has a forward lobe.
struct LobedMedium {
  double anisotropy;
  double grid_extinction;  // of the grid's densities, relative to the medium's
  double fog_density;      // [1/u]
  FogBall fog;
};

// Optical depths of view rays, as fine as a grid is. Keeps references to both.
class ViewDepths {
 public:
  ViewDepths(const SourceGrid& grid, const LobedMedium& medium);

  // The depth of the first `distance` from a point on, in the unit direction w.
  [[nodiscard]] double operator()(const glm::dvec3& begin, const glm::dvec3& w,
                                  double distance) const;
  // The distance from there at which the medium ends; at most 0 if it is behind.
  [[nodiscard]] double end(const glm::dvec3& begin, const glm::dvec3& w) const;

 private:
  // The density of the Gaussians, as the grid has it.
  [[nodiscard]] double density(const glm::dvec3& point) const;

  const SourceGrid& grid_;
  const LobedMedium& medium_;
  bool has_gaussians_ = false;
  FogBall gaussians_;  // around all of them
};

}  // namespace brume
