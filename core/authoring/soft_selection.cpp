#include "core/authoring/soft_selection.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace brume {
namespace {

// A cell of a grid as wide as the radius: what is near lies in it or in one beside it.
using SoftCells = std::unordered_map<std::uint64_t, std::vector<glm::dvec3>>;

// Cells that share a key only cost time.
std::uint64_t cell_key(const glm::dvec3& cell) {
  const auto part = [](double v) { return static_cast<std::uint64_t>(std::llround(v)) & 0x1fffff; };
  return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);
}

glm::dvec3 cell_of(const glm::dvec3& point, double radius) {
  return glm::clamp(glm::floor(point / radius), -1e15, 1e15);
}

double nearest_distance(const SoftCells& cells, const glm::dvec3& point, double radius) {
  double nearest = radius;
  const glm::dvec3 cell = cell_of(point, radius);
  for (int k = 0; k < 27; ++k) {
    const glm::dvec3 beside(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    const auto found = cells.find(cell_key(cell + beside));
    if (found == cells.end()) continue;
    for (const glm::dvec3& center : found->second) {
      nearest = std::min(nearest, glm::distance(center, point));
    }
  }
  return nearest;
}

}  // namespace

std::vector<SoftMember> soft_members(const Medium& medium, std::span<const GaussianId> ids,
                                     double radius) {
  SoftCells cells;
  for (const GaussianId id : ids) {
    const glm::dvec3& center = medium.centers()[*medium.index_of(id)];
    cells[cell_key(cell_of(center, radius))].push_back(center);
  }
  std::vector<SoftMember> members;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (std::binary_search(ids.begin(), ids.end(), medium.ids()[i])) continue;
    const double t = nearest_distance(cells, medium.centers()[i], radius) / radius;
    const double weight = (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t);
    if (t < 1.0) members.push_back({i, weight});
  }
  return members;
}

}  // namespace brume
