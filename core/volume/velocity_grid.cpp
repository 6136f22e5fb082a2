#include "core/volume/velocity_grid.h"

namespace brume {

glm::dvec3 VelocityGrid::at(const glm::dvec3& world) const {
  glm::dvec3 velocity;
  for (int k = 0; k < 3; ++k) {
    const DensityGrid& grid = components[static_cast<std::size_t>(k)];
    velocity[k] = grid.at(grid.to_voxel(world));
  }
  return turn * velocity;
}

void rotate(VelocityGrid& grid, const glm::dquat& turn) {
  for (DensityGrid& component : grid.components) rotate(component, turn);
  grid.turn = turn * grid.turn;
}

std::vector<Gaussian> advected(std::span<const Gaussian> gaussians, const VelocityGrid& velocity,
                               double seconds) {
  std::vector<Gaussian> result(gaussians.begin(), gaussians.end());
  for (Gaussian& g : result) {
    const glm::dvec3 k1 = velocity.at(g.center);
    const glm::dvec3 k2 = velocity.at(g.center + 0.5 * seconds * k1);
    const glm::dvec3 k3 = velocity.at(g.center + 0.5 * seconds * k2);
    const glm::dvec3 k4 = velocity.at(g.center + seconds * k3);
    g.center += seconds / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return result;
}

}  // namespace brume
