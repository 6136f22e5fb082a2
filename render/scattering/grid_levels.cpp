#include "render/scattering/grid_levels.h"

namespace brume {

GridLevels::GridLevels(const SourceGrid& grid, const glm::dvec3& origin,
                       const NodeVisibility& visibility) {
  for (const SourceGrid::Level& level : grid.levels()) {
    GridLevel& relative = levels_[count_];
    relative.first = glm::vec3(level.first - origin);
    relative.per_unit = 1.0f / level.nodes.spacing;
    relative.count = level.nodes.count;
    relative.values = level.values.data();
    relative.incident = level.incident.data();
    relative.occlusion_bits = visibility.occlusion_bits;
    relative.eye_layers = visibility.layers[count_];
    if (level.surfaces && !level.surfaces->hidden().empty()) {
      relative.blocked = level.surfaces->hidden().data();
    }
    ++count_;
  }
}

}  // namespace brume
