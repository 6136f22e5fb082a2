#pragma once

#include <cstddef>

#include "render/gl/film_airlight.h"
#include "render/gl/light_tables.h"

namespace brume::gl {

// brume::FilmSlices on the device: boundaries of slices at nodes between tiles.
class SliceTexture {
 public:
  // For the tiles of `lists`; `lights` are uploaded. `slices` and `light_count` decide how many
  // there are.
  void choose(Programs& programs, DeviceClock& clock, LightTables& lights, std::size_t light_count,
              int slices, TileLists& lists, const FilmView& view, const FilmTextures& textures);
  // What shaders/ray_slices.glsl needs.
  void bind(const Program& program) const;

 private:
  int stride_ = 0;
  Buffer chosen_;
  Texture nodes_;
};

}  // namespace brume::gl
