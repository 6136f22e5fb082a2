#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/lighting/source_grid.h"

namespace brume::gl {

// Appends values of the nodes of a level, a multiple of four floats each, as shaders take them: in
// the last of the first four, which must be of no use, the bits of GridOcclusion::blocked().
void append_nodes(const SourceGrid::Level& level, std::span<const float> values,
                  std::vector<glm::vec4>& target);

}  // namespace brume::gl
