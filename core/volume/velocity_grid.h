#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/medium/gaussian.h"
#include "core/volume/density_grid.h"

namespace brume {

// A velocity sampled on a grid, linear between its points and 0 where there is none.
struct VelocityGrid {
  // x, y and z of the velocity [u/s], which may be negative; where each is sampled its own grid
  // says, since solvers store them on different faces of a voxel.
  std::array<DensityGrid, 3> components;
  glm::dquat turn{1.0, 0.0, 0.0, 0.0};  // turns those into the world's x, y and z

  [[nodiscard]] glm::dvec3 at(const glm::dvec3& world) const;
};

// Turns a grid about the origin of the world.
void rotate(DensityGrid& grid, const glm::dquat& turn);
void rotate(VelocityGrid& grid, const glm::dquat& turn);

// Gaussians whose centres have moved with a steady velocity for a time [s] (Runge and Kutta's
// method of fourth order); radii and densities stay.
std::vector<Gaussian> advected(std::span<const Gaussian> gaussians, const VelocityGrid& velocity,
                               double seconds);

}  // namespace brume
