#pragma once

#include <glm/vec3.hpp>

#include "brume/scene.h"

namespace brume {

// A square of 2 u around the origin that faces +y, with a checkerboard of 4 x 4 holes and squares,
// and whether it is there.
Surface checkered_leaf();
bool is_leaf_there(double x, double z);
// The same of squares of their own.
std::vector<Surface> leaf_of_squares();

// A square of 2 u around the origin that faces +y.
Surface pane(AlphaMode alpha, double opacity, const glm::dvec3& transmission);

// A light in fog above a floor, seen from the side; surfaces are to hang between them, at y = 1.
Scene lit_from_above();

}  // namespace brume
