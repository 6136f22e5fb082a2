#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/cpu/light_table.h"
#include "render/cpu/sliced_airlight.h"
#include "render/gl/tile_lists.h"

namespace brume::gl {

class ShadowMaps;

// A DirectionMap as shaders/direction_map.glsl has it.
struct MapUniforms {
  glm::vec4 right{0.0f}, up{0.0f}, axis{0.0f}, offset{0.0f};
  glm::ivec4 cells{0};

  MapUniforms() = default;
  // `first`: where its values begin.
  MapUniforms(const DirectionMap& map, std::size_t first);
};

// Those of a program that makes one map.
void set_map(const Program& program, const MapUniforms& map);

// The lights of a frame on the device, with their tables (LightTable). A table is kept while its
// light and the medium stay.
class LightTables {
 public:
  // Finds out which table each light needs; the maps of all.
  std::span<const DirectionMap> lay_out(const MediumIndex& medium, std::uint64_t revision,
                                        std::span<const SlicedLight> lights,
                                        const LightTableSize& size);
  // Makes the tables that are not there yet. Returns the Gaussian x ray pairs that this took; waits
  // for the device if any is made.
  std::uint64_t build(Programs& programs, MediumBuffers& medium);
  // Uploads the lights relative to a point; `lights` are those of lay_out(), or there are no
  // tables. `shadows` may be null.
  void upload(std::span<const SlicedLight> lights, const ShadowMaps* shadows,
              const glm::dvec3& origin);
  // As storage blocks 0 and 1.
  void bind();

 private:
  struct Table {
    glm::dvec3 light;
    LightTableLayout layout;
    bool made = false;
  };
  std::uint64_t revision_ = 0;
  LightTableSize size_;
  float most_depth_ = 0.0f;  // that a table holds
  std::vector<Table> tables_;
  std::vector<DirectionMap> maps_;
  Buffer lights_, values_, pairs_;
};

}  // namespace brume::gl
