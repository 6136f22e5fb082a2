#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/cpu/direction_map.h"
#include "render/cpu/sliced_airlight.h"
#include "render/gl/mesh_buffers.h"

namespace brume::gl {

// How far lights shine before a surface stops them: ShadowMap of each on the device. A map is kept
// while its light, its directions and the surfaces stay.
class ShadowMaps {
 public:
  // `directions`: of each light's map.
  void make(Programs& programs, MeshBuffers& mesh, std::span<const SlicedLight> lights,
            std::span<const DirectionMap> directions);
  // No light has any.
  void clear() { maps_.clear(); }

  [[nodiscard]] bool empty() const { return maps_.empty(); }
  [[nodiscard]] const DirectionMap& map(std::size_t light) const { return maps_[light].directions; }
  // Where its values begin.
  [[nodiscard]] std::size_t first(std::size_t light) const { return light * slot_; }
  Buffer& values() { return values_; }

 private:
  struct Map {
    glm::dvec3 light{0.0};
    DirectionMap directions;
    bool made = false;
  };
  std::uint64_t revision_ = 0;  // of the surfaces
  std::size_t slot_ = 0;        // floats that each light has room for
  std::vector<Map> maps_;
  Buffer values_;
};

}  // namespace brume::gl
