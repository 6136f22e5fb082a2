#include "render/scattering/lobe/view_depths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/scattering/lobe/level_cells.h"

namespace brume {

ViewDepths::ViewDepths(const SourceGrid& grid, const LobedMedium& medium)
    : grid_(grid), medium_(medium) {
  const auto is_zero = [](float density) { return density == 0.0f; };
  has_gaussians_ = !std::ranges::all_of(grid.levels(), [&](const SourceGrid::Level& level) {
    return std::ranges::all_of(level.density, is_zero);
  });
  const SourceGrid::Level& outermost = grid.levels().back();
  const glm::dvec3 half =
      0.5 * static_cast<double>(outermost.nodes.spacing) * glm::dvec3(outermost.nodes.count - 1);
  gaussians_ = {outermost.first + half, glm::length(half)};
}

double ViewDepths::operator()(const glm::dvec3& begin, const glm::dvec3& w, double distance) const {
  double depth = 0.0;
  if (medium_.fog_density > 0.0) {
    depth = medium_.fog_density * medium_.fog.length(begin, w, distance);
  }
  if (!has_gaussians_) return depth;
  const FogInterval part = gaussians_.interval(begin, w);
  const double start = std::max(part.begin, 0.0);
  const double length = std::min(part.end, distance) - start;
  if (length <= 0.0) return depth;
  constexpr double min_steps = 4.0;
  constexpr double max_steps = 64.0;
  const double spacing = static_cast<double>(grid_.levels().front().nodes.spacing);
  const auto steps =
      static_cast<int>(std::clamp(std::ceil(length / spacing), min_steps, max_steps));
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += density(begin + (start + (i + 0.5) / steps * length) * w);
  return depth + sum * length / steps / medium_.grid_extinction;
}

double ViewDepths::end(const glm::dvec3& begin, const glm::dvec3& w) const {
  const double fog = medium_.fog_density > 0.0 ? medium_.fog.interval(begin, w).end : 0.0;
  return std::max(fog, has_gaussians_ ? gaussians_.interval(begin, w).end : 0.0);
}

double ViewDepths::density(const glm::dvec3& point) const {
  for (const SourceGrid::Level& level : grid_.levels()) {
    const glm::dvec3 cells = in_cells(level, point);
    if (!holds(level, cells)) continue;
    const glm::ivec3 first = cell_of(level, cells);
    const glm::vec3 f(cells - glm::dvec3(first));
    const auto row = static_cast<std::size_t>(level.nodes.count.x);
    const std::size_t slab = row * static_cast<std::size_t>(level.nodes.count.y);
    const float* const corner = level.density.data() + node_index(level.nodes, first);
    const auto along = [&](std::size_t step) {
      return glm::mix(corner[step], corner[step + 1], f.x);
    };
    return static_cast<double>(glm::mix(glm::mix(along(0), along(row), f.y),
                                        glm::mix(along(slab), along(slab + row), f.y), f.z));
  }
  return 0.0;
}

}  // namespace brume
