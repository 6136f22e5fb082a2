#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "render/gl/resources.h"
#include "render/scattering/node_visibility.h"
#include "render/scattering/source_grid.h"

namespace brume::gl {

// Appends values of the nodes of a level, a multiple of four floats each, as shaders take them: in
// the last of the first four, which must be of no use, the bits of GridOcclusion::hidden().
void append_nodes(const SourceGrid::Level& level, std::span<const float> values,
                  std::vector<glm::vec4>& target);

// Sets the elements [index] of the uniforms NAME_first, NAME_count and NAME_eye_layers, see
// shaders/source.glsl: where a level lies from `origin`, the index of its first value, and the
// eye's layers in it.
void set_level(const Program& program, const std::string& name, std::size_t index,
               const SourceGrid::Level& level, const glm::dvec3& origin,
               const NodeVisibility& visibility, std::size_t first_value);

}  // namespace brume::gl
