#include "render/gl/grid_nodes.h"

#include <bit>
#include <cstdint>

namespace brume::gl {

void append_nodes(const SourceGrid::Level& level, std::span<const float> values,
                  std::vector<glm::vec4>& target) {
  const std::span<const std::uint32_t> blocked =
      level.surfaces ? level.surfaces->hidden() : std::span<const std::uint32_t>{};
  const std::size_t size = values.size() / level.nodes.size();
  for (std::size_t node = 0; node < level.nodes.size(); ++node) {
    const std::size_t first = target.size();
    for (std::size_t i = 0; i < size; i += 4) {
      const float* v = values.data() + node * size + i;
      target.emplace_back(v[0], v[1], v[2], v[3]);
    }
    // Another bit makes an ordinary float of them, which no device changes.
    constexpr std::uint32_t normal = 1u << 30;
    if (!blocked.empty()) target[first].w = std::bit_cast<float>(normal | blocked[node]);
  }
}

void set_level(const Program& program, const std::string& name, std::size_t index,
               const SourceGrid::Level& level, const glm::dvec3& origin,
               const NodeVisibility& visibility, std::size_t first_value) {
  const std::string element = std::to_string(index) + "]";
  program.set((name + "_first[" + element).c_str(),
              glm::vec4(glm::vec3(level.first - origin), 1.0f / level.nodes.spacing));
  program.set((name + "_count[" + element).c_str(),
              glm::ivec4(level.nodes.count, static_cast<int>(first_value)));
  const NodeVisibility::Layers& layers = visibility.layers[index];
  const glm::ivec3& high = layers.is_high;
  program.set((name + "_eye_layers[" + element).c_str(),
              glm::ivec4(layers.cell, high.x | high.y << 1 | high.z << 2));
}

}  // namespace brume::gl
