#include "render/grid/node_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace brume {
namespace {

// Centred, with `more` layers than it takes.
NodeLayout centred(const glm::dvec3& low, const glm::dvec3& high, double min_spacing, int max_nodes,
                   const glm::dvec3& more) {
  NodeLayout layout;
  GridNodes& nodes = layout.nodes;
  const glm::dvec3 extent = high - low;
  double spacing = std::max(min_spacing, std::cbrt(extent.x * extent.y * extent.z / max_nodes));
  for (;; spacing *= 1.02) {
    nodes.spacing = static_cast<float>(spacing);
    const glm::dvec3 cells = glm::ceil(extent / static_cast<double>(nodes.spacing)) + more;
    if ((cells.x + 1.0) * (cells.y + 1.0) * (cells.z + 1.0) > static_cast<double>(max_nodes))
      continue;
    nodes.count = glm::max(glm::ivec3(cells) + 1, 2);
    const glm::dvec3 covered = glm::dvec3(nodes.count - 1) * static_cast<double>(nodes.spacing);
    layout.first = 0.5 * (low + high) - 0.5 * covered;
    return layout;
  }
}

}  // namespace

NodeLayout lay_out(const glm::dvec3& low, const glm::dvec3& high, double min_spacing, int max_nodes,
                   const AxisPlanes& planes) {
  const auto shift_of = [&](const NodeLayout& layout) {
    const double spacing = static_cast<double>(layout.nodes.spacing);
    glm::dvec3 shift(0.0);
    for (int k = 0; k < 3; ++k) {
      shift[k] = planes.shift(k, low[k] - spacing, high[k] + spacing, layout.first[k], spacing);
    }
    return shift;
  };
  const NodeLayout plain = centred(low, high, min_spacing, max_nodes, glm::dvec3(0.0));
  const glm::bvec3 is_on_layer = glm::notEqual(shift_of(plain), glm::dvec3(0.0));
  if (!glm::any(is_on_layer)) return plain;
  const glm::dvec3 more(is_on_layer);
  NodeLayout layout = centred(low, high, min_spacing, max_nodes, more);
  layout.first += more * shift_of(layout);
  return layout;
}

}  // namespace brume
