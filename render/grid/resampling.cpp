#include "render/grid/resampling.h"

#include <cstddef>
#include <glm/common.hpp>

namespace brume {

Resampling::Resampling(const glm::dvec3& from_first, const GridNodes& from, const glm::dvec3& first,
                       const GridNodes& nodes)
    : from_(from),
      nodes_(nodes),
      scale_(static_cast<double>(nodes.spacing) / static_cast<double>(from.spacing)),
      offset_((first - from_first) / static_cast<double>(from.spacing)) {}

float Resampling::at(std::span<const float> values, const glm::ivec3& node) const {
  const glm::dvec3 last(from_.count - 1);
  const glm::dvec3 x = glm::clamp(offset_ + scale_ * glm::dvec3(node), glm::dvec3(0.0), last);
  const glm::ivec3 low = glm::min(glm::ivec3(x), from_.count - 2);
  const glm::vec3 f(x - glm::dvec3(low));
  const auto row = static_cast<std::size_t>(from_.count.x);
  const std::size_t slab = row * static_cast<std::size_t>(from_.count.y);
  const float* corner = values.data() + static_cast<std::size_t>(low.x) +
                        static_cast<std::size_t>(low.y) * row +
                        static_cast<std::size_t>(low.z) * slab;
  const auto edge = [&](std::size_t k) { return glm::mix(corner[k], corner[k + 1], f.x); };
  return glm::mix(glm::mix(edge(0), edge(row), f.y), glm::mix(edge(slab), edge(slab + row), f.y),
                  f.z);
}

void Resampling::apply(std::span<const float> values, std::span<float> result) const {
  std::size_t i = 0;
  for (int z = 0; z < nodes_.count.z; ++z) {
    for (int y = 0; y < nodes_.count.y; ++y) {
      for (int x = 0; x < nodes_.count.x; ++x, ++i) result[i] = at(values, {x, y, z});
    }
  }
}

void Resampling::apply_to_border(std::span<const float> values, std::span<float> result) const {
  const glm::ivec3 last = nodes_.count - 1;
  std::size_t i = 0;
  for (int z = 0; z <= last.z; ++z) {
    for (int y = 0; y <= last.y; ++y) {
      for (int x = 0; x <= last.x; ++x, ++i) {
        const bool is_border =
            x == 0 || y == 0 || z == 0 || x == last.x || y == last.y || z == last.z;
        if (is_border) result[i] = at(values, {x, y, z});
      }
    }
  }
}

}  // namespace brume
