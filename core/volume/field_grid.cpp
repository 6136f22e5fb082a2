#include "core/volume/field_grid.h"

namespace brume {

std::optional<glm::dvec3> FieldGrid::at(const glm::dvec3& world) const {
  const glm::dvec3 voxel = coverage.to_voxel(world);
  const double weight = coverage.at(voxel);
  if (!(weight > 1e-6)) return std::nullopt;
  glm::dvec3 value(0.0);
  for (std::size_t k = 0; k < components.size(); ++k) {
    value[static_cast<int>(k)] = components[k].at(voxel) / weight;
  }
  return value;
}

void rotate(FieldGrid& field, const glm::dquat& turn) {
  for (DensityGrid& component : field.components) rotate(component, turn);
  rotate(field.coverage, turn);
}

}  // namespace brume
