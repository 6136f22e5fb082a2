#pragma once

#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "core/scene/lights/intensity_map.h"
#include "render/gl/resources.h"
#include "render/gl/shader_structs.h"
#include "render/gl/tile_lists.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/slices/sliced_light.h"

namespace brume::gl {

// The maps of the lights' photometric profiles and pictures, side by side in one texture. Uploaded
// when there are others.
class ProfileMaps {
 public:
  void upload(std::span<const SlicedLight> lights);
  // The first texel of a map that a light of the last upload has.
  [[nodiscard]] glm::ivec2 place(const IntensityMap& map) const;
  // Binds them as `profiles`.
  void bind(const Program& program);

 private:
  [[nodiscard]] glm::ivec2 place_of(std::size_t index) const;

  std::vector<std::shared_ptr<const IntensityMap>> maps_;
  int side_ = 0;  // of the largest
  Texture texture_;
};

class ShadowMaps;

// A map whose first value has this index.
MapData map_data(const DirectionMap& map, std::size_t first);

// Sets the uniform `map` of a program that builds one.
void set_map(const Program& program, const MapData& map);

// Dispatches a program whose work groups take `bundle_side`^2 rays from one point each.
void dispatch_bundles(const Program& program, const glm::ivec2& rays);

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
  // Binds them as `Lights`, `Tables` and `profiles`.
  void bind(const Program& program);

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
  ProfileMaps profiles_;
};

}  // namespace brume::gl
