#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "brume/density_grid.h"

namespace brume {

// A sampled quantity of one or three components that has values in some places only, where it is
// trilinear: a colour, a temperature.
struct FieldGrid {
  std::vector<DensityGrid> components;  // 1 or 3, of the same transform
  DensityGrid coverage;                 // how many values a voxel has

  // The value at a point of the world, a single component in x; nullopt where it has none.
  [[nodiscard]] std::optional<glm::dvec3> at(const glm::dvec3& world) const;
};

// Rotates a field about the world origin; its values stay.
void rotate(FieldGrid& field, const glm::dquat& turn);

}  // namespace brume
