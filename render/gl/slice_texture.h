#pragma once

#include <cstddef>
#include <vector>

#include "render/gl/film_airlight.h"
#include "render/gl/optical_depth_tables.h"

namespace brume::gl {

// Device counterpart of FilmSlices: slice boundaries at nodes between tiles.
class SliceTexture {
 public:
  // Chooses boundaries for the tiles of `lists`; `lights` must be uploaded. `slices` and
  // `light_count` determine their number.
  void choose(Programs& programs, DeviceClock& clock, OpticalDepthTables& lights,
              std::size_t light_count, int slices, TileLists& lists, const FilmView& view,
              const FilmTextures& textures);
  // Binds the inputs of shaders/ray_slices.glsl.
  void bind(const Program& program) const;

  // The boundaries of the last choose(), for tests: per tile, and per node all `stride()` of them;
  // empty where there is no medium.
  [[nodiscard]] std::vector<std::vector<float>> download_tiles() const;
  [[nodiscard]] std::vector<std::vector<float>> download_nodes() const;
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(stride_); }

 private:
  int stride_ = 0;
  glm::ivec2 tiles_{0};
  Buffer chosen_;
  Texture nodes_;
};

}  // namespace brume::gl
