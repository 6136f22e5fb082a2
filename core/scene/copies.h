#pragma once

#include <vector>

#include "brume/mesh_arrays.h"
#include "brume/surface.h"

namespace brume {

// The surface that copies are scattered over; null: there is none of that name.
const Surface* find_scattered_over(const Scatter& scatter, const std::vector<Surface>& surfaces);

// How many copies are scattered over a surface; not whole, and beyond what memory holds perhaps.
double scattered_count(const Scatter& scatter, const Surface& over);

// The copies of all surfaces, counted in the same way.
double copy_count(const std::vector<Surface>& surfaces);

// Their placements. `over` stands for its mesh at its own placement.
CopyPlacements scattered(const Scatter& scatter, const Surface& over);

// The surfaces with `placed_copies` in place of `copies`. Those are the same object while nothing
// changes.
std::vector<Surface> with_placed_copies(std::vector<Surface> surfaces);

// The greatest distance of a vertex of it or of a copy to a point; < 0: it has none.
double farthest_vertex(const Surface& surface, const glm::dvec3& point);

}  // namespace brume
