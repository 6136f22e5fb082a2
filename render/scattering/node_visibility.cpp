#include "render/scattering/node_visibility.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

namespace brume {
namespace {

// The eye's place in cells from the first node; nullopt outside a level, and where it has no
// surfaces.
std::optional<glm::dvec3> coordinate_in(const SourceGrid::Level& level, const glm::dvec3& eye) {
  if (!level.surfaces || level.surfaces->hidden().empty()) return std::nullopt;
  const glm::dvec3 coordinate = (eye - level.first) / static_cast<double>(level.nodes.spacing);
  if (glm::any(glm::lessThan(coordinate, glm::dvec3(0.0))) ||
      glm::any(glm::greaterThan(coordinate, glm::dvec3(level.nodes.count - 1)))) {
    return std::nullopt;
  }
  return coordinate;
}

// The side of each axis on which the eye sees more corners of its cell counts; none does if it sees
// as many on both.
NodeVisibility::Layers layers_around(const SourceGrid::Level& level, const glm::dvec3& coordinate) {
  const glm::ivec3 cell = glm::min(glm::ivec3(coordinate), level.nodes.count - 2);
  glm::ivec3 seen_more(0);
  for (int c = 0; c < 8; ++c) {
    const glm::ivec3 corner(c & 1, c >> 1 & 1, c >> 2);
    std::uint32_t links = 0;
    for (int other = 0; other < 8; ++other) {
      const glm::ivec3 link = glm::ivec3(other & 1, other >> 1 & 1, other >> 2) - corner;
      if (other != c) links |= 1u << neighbour_index(link.x, link.y, link.z);
    }
    const glm::dvec3 to_eye =
        static_cast<double>(level.nodes.spacing) * (coordinate - glm::dvec3(cell + corner));
    if (!level.surfaces->hides(node_index(level.nodes, cell + corner), links, glm::vec3(to_eye))) {
      seen_more += 2 * corner - 1;
    }
  }
  NodeVisibility::Layers layers;
  for (int k = 0; k < 3; ++k) {
    if (seen_more[k] != 0) layers.cell[k] = cell[k];
    layers.is_high[k] = seen_more[k] > 0 ? 1 : 0;
  }
  return layers;
}

}  // namespace

NodeVisibility::NodeVisibility(const SourceGrid& grid, const glm::dvec3& eye) {
  bool is_finest = true;
  for (std::size_t k = 0; k < grid.levels().size(); ++k) {
    const SourceGrid::Level& level = grid.levels()[k];
    const auto coordinate = coordinate_in(level, eye);
    if (!coordinate) continue;
    layers[k] = layers_around(level, *coordinate);
    if (!is_finest) continue;
    is_finest = false;
    const std::size_t nearest = node_index(level.nodes, glm::ivec3(glm::round(*coordinate)));
    const std::uint32_t blocked = level.surfaces->hidden()[nearest];
    occlusion_bits = GridOcclusion::all_bits & ~(blocked & GridOcclusion::enclosed_bit);
  }
}

}  // namespace brume
