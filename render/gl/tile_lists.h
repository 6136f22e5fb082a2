#pragma once

#include <cstdint>

#include "brume/revision.h"
#include "core/scene/camera_rays.h"
#include "render/geometry/medium_index.h"
#include "render/gl/programs.h"
#include "render/simd/gaussian_kernels.h"

namespace brume::gl {

// The Gaussians of a medium on the device.
class MediumBuffers {
 public:
  // Uploads the medium if it has changed.
  void update(const MediumIndex& medium);

  [[nodiscard]] std::size_t count() const { return count_; }
  // Binds them as `Centers` and `Shapes`.
  void bind(const Program& program);
  // Binds the optics of Gaussians that have their own, as `optics`.
  void bind_optics(const Program& program) { program.bind("optics", optics_); }
  [[nodiscard]] bool has_optics() const { return has_optics_; }
  // Binds them as `ellipsoids`, for programs with the word that defines them.
  void bind_ellipsoids(const Program& program) const { program.bind("ellipsoids", ellipsoids_); }
  [[nodiscard]] const char* defined() const { return has_ellipsoids_ ? "ELLIPSOIDS" : ""; }

 private:
  void upload_optics(std::span<const RelativeOptics> all);
  void upload_ellipsoids(const GaussianBatch& batch, const MediumIndex& medium);

  Revision revision_ = 0;  // of the index
  std::size_t count_ = 0;
  Buffer centers_;  // x y z per Gaussian, double
  Buffer shapes_;   // GaussianShape
  Texture optics_;  // a texel of emission and albedo per Gaussian, row by row
  bool has_optics_ = false;
  Texture ellipsoids_;  // see shaders/ellipsoids.glsl
  bool has_ellipsoids_ = false;
};

// Tile binning on the device: for every tile the Gaussians that its rays may meet; Tiles::Lists in
// another order.
class TileLists {
 public:
  // For rays that see `scale` pixels for one of the tiles' film. Waits for the device. Throws
  // OutOfMemory if the lists exceed `max_bytes`.
  void build(Programs& programs, MediumBuffers& medium, const MediumIndex& index,
             const CameraRays& rays, const Film& film, int scale, std::int64_t max_bytes);

  [[nodiscard]] std::size_t used() const { return used_; }  // Gaussians in any list
  [[nodiscard]] const glm::ivec2& tiles() const { return tiles_; }
  [[nodiscard]] const glm::ivec2& sample_film() const { return sample_film_; }
  // Binds them as `Seen`, `Offsets` and `Entries`.
  void bind(const Program& program);
  // MediumBuffers::defined() of the medium that they were built for, which bind() binds too.
  [[nodiscard]] const char* defined() const { return medium_->defined(); }
  Buffer& offsets() { return offsets_; }  // start of each list
  Buffer& entries() { return entries_; }

 private:
  glm::ivec2 tiles_{0};
  glm::ivec2 sample_film_{0};
  std::size_t used_ = 0;
  const MediumBuffers* medium_ = nullptr;
  Buffer seen_, rectangles_, totals_, cursors_, offsets_, entries_;
};

}  // namespace brume::gl
