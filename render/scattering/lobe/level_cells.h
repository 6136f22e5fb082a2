#pragma once

#include <glm/common.hpp>
#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "render/scattering/source_grid.h"

namespace brume {

inline glm::dvec3 node_position(const SourceGrid::Level& level, const glm::ivec3& node) {
  return level.first + static_cast<double>(level.nodes.spacing) * glm::dvec3(node);
}

// A point in cells from a level's first node.
inline glm::dvec3 in_cells(const SourceGrid::Level& level, const glm::dvec3& p) {
  return (p - level.first) / static_cast<double>(level.nodes.spacing);
}

inline bool holds(const SourceGrid::Level& level, const glm::dvec3& cells) {
  return glm::all(glm::greaterThanEqual(cells, glm::dvec3(0.0))) &&
         glm::all(glm::lessThanEqual(cells, glm::dvec3(level.nodes.count - 1)));
}

// The first node of the cell that a point is in, or the nearest one.
inline glm::ivec3 cell_of(const SourceGrid::Level& level, const glm::dvec3& cells) {
  return glm::clamp(glm::ivec3(glm::floor(cells)), glm::ivec3(0),
                    glm::max(level.nodes.count - 2, 0));
}

}  // namespace brume
