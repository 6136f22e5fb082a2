#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/revision.h"
#include "render/gl/tile_lists.h"
#include "render/lighting/optical_depth_table.h"
#include "render/lighting/sliced_light.h"

namespace brume::gl {

class ShadowMaps;

// A DirectionMap in the layout of shaders/direction_map.glsl.
struct MapUniforms {
  glm::vec4 right{0.0f}, up{0.0f}, axis{0.0f}, offset{0.0f};
  glm::ivec4 cells{0};

  MapUniforms() = default;
  // `first`: index of its first value.
  MapUniforms(const DirectionMap& map, std::size_t first);
};

// Sets the uniforms of a program that builds one map.
void set_map(const Program& program, const MapUniforms& map);

// Lights and their optical depth tables on the device. A table is cached while its light and the
// medium are unchanged.
class OpticalDepthTables {
 public:
  // Lays out the table of each light; returns the maps.
  std::span<const DirectionMap> lay_out(const MediumIndex& medium,
                                        std::span<const SlicedLight> lights,
                                        const OpticalDepthTableSize& size);
  // Builds missing tables. Returns the Gaussian x ray pairs evaluated; waits for the device if any
  // is built.
  std::uint64_t build(Programs& programs, MediumBuffers& medium);
  // Uploads the lights relative to a point; `lights` as in lay_out(), or without tables. `shadows`
  // may be null.
  void upload(std::span<const SlicedLight> lights, const ShadowMaps* shadows,
              const glm::dvec3& origin);
  // As storage blocks 0 and 1.
  void bind();

 private:
  struct Table {
    glm::dvec3 light;
    OpticalDepthTableLayout layout;
    bool made = false;
  };
  Revision revision_ = 0;
  OpticalDepthTableSize size_;
  float max_depth_ = 0.0f;  // maximum optical depth of a table
  std::vector<Table> tables_;
  std::vector<DirectionMap> maps_;
  Buffer lights_, values_, pairs_;
};

}  // namespace brume::gl
