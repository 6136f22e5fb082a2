#pragma once

#include <span>
#include <vector>

#include "brume/revision.h"
#include "render/geometry/direction_map.h"
#include "render/gl/mesh_buffers.h"
#include "render/slices/sliced_light.h"

namespace brume::gl {

// Shadow maps of all lights on the device. A map is cached while its light, directions and the
// surfaces are unchanged.
class ShadowMaps {
 public:
  // `directions`: one map per light.
  void make(Programs& programs, MeshBuffers& mesh, std::span<const SlicedLight> lights,
            std::span<const DirectionMap> directions);
  // Removes all maps.
  void clear() { maps_.clear(); }

  [[nodiscard]] bool empty() const { return maps_.empty(); }
  [[nodiscard]] const DirectionMap& map(std::size_t light) const { return maps_[light].directions; }
  [[nodiscard]] double start(std::size_t light) const { return maps_[light].start; }
  // Index of a light's first value.
  [[nodiscard]] std::size_t first(std::size_t light) const { return light * slot_; }
  Buffer& values() { return values_; }

 private:
  struct Map {
    glm::dvec3 light{0.0};
    DirectionMap directions;
    double start = 0.0;  // shadow_start()
    bool made = false;
  };
  Revision revision_ = 0;  // revision of the surfaces
  std::size_t slot_ = 0;   // capacity per light in floats
  std::vector<Map> maps_;
  Buffer values_;
};

}  // namespace brume::gl
