#pragma once

#include <array>
#include <span>
#include <vector>

#include "brume/density_grid.h"
#include "brume/gaussian.h"

namespace brume {

// A sampled velocity field, trilinear, 0 outside.
struct VelocityGrid {
  // Components x, y, z [u/s], each on its own grid, since solvers store them on different faces of
  // a voxel.
  std::array<DensityGrid, 3> components;
  glm::dquat turn{1.0, 0.0, 0.0, 0.0};  // rotates components to world axes

  [[nodiscard]] glm::dvec3 at(const glm::dvec3& world) const;
};

// Rotates a grid and its velocities about the world origin.
void rotate(VelocityGrid& grid, const glm::dquat& turn);

// Advects centers through a steady velocity field for a time [s] (fourth-order Runge-Kutta); radii
// and densities are unchanged.
std::vector<Gaussian> advected(std::span<const Gaussian> gaussians, const VelocityGrid& velocity,
                               double seconds);

}  // namespace brume
