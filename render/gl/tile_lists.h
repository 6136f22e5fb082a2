#pragma once

#include <cstdint>

#include "core/scene/camera.h"
#include "render/gl/programs.h"
#include "render/medium_index.h"

namespace brume::gl {

// The Gaussians of a medium on the device.
class MediumBuffers {
 public:
  // Uploads the medium unless `revision` is the last one's.
  void update(const MediumIndex& medium, std::uint64_t revision);

  [[nodiscard]] std::size_t count() const { return count_; }
  // As storage blocks 0 and 1.
  void bind();

 private:
  std::uint64_t revision_ = 0;  // 0: of none
  std::size_t count_ = 0;
  Buffer centers_;  // x y z of each, double
  Buffer shapes_;   // a, scale, cutoff, reach of each
};

// For every tile of a film the Gaussians that its rays may meet, listed on the device:
// Tiles::Lists, but for their order.
class TileLists {
 public:
  // Of rays that see `scale` pixels for one of the tiles' film. Waits for the device. Throws
  // OutOfMemory where lists do not fit.
  void build(Programs& programs, MediumBuffers& medium, const MediumIndex& index,
             const CameraRays& rays, const Film& film, int scale, std::int64_t most_bytes);

  [[nodiscard]] std::size_t used() const { return used_; }  // Gaussians in any list
  [[nodiscard]] const glm::ivec2& tiles() const { return tiles_; }
  [[nodiscard]] const glm::ivec2& sample_film() const { return sample_film_; }
  Buffer& seen() { return seen_; }        // of the Gaussians from the eye: see project.glsl
  Buffer& offsets() { return offsets_; }  // where lists begin
  Buffer& entries() { return entries_; }

 private:
  glm::ivec2 tiles_{0};
  glm::ivec2 sample_film_{0};
  std::size_t used_ = 0;
  Buffer seen_, rectangles_, totals_, cursors_, offsets_, entries_;
};

}  // namespace brume::gl
