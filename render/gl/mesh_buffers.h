#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/camera.h"
#include "render/cpu/visibility.h"
#include "render/gl/programs.h"

namespace brume::gl {

// The surfaces of a scene on the device, for rays.
class MeshBuffers {
 public:
  // Takes them unless `revision` is the last one's.
  void update(const Visibility& visibility, std::uint64_t revision);

  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  // As shaders/trace.glsl has them: storage blocks 4 and 5, and the program's uniforms.
  void bind(const Program& program);
  // What rays are relative to.
  [[nodiscard]] const glm::dvec3& middle() const { return middle_; }
  [[nodiscard]] double least_gap() const { return least_gap_; }

  // Finds the first surface on each view ray, and how far it is (< 0: none).
  void find_hits(Programs& programs, const CameraRays& rays, const Film& film, Texture& depth);
  // Those of the last find_hits(), fetched: SurfaceHit per pixel.
  [[nodiscard]] std::vector<SurfaceHit> download_hits() const;
  // Per pixel: see shaders/visibility.glsl.
  Buffer& hits() { return hits_; }

 private:
  std::uint64_t revision_ = 0;  // 0: of none
  glm::dvec3 middle_{0.0};
  double radius_ = 0.0;
  double least_gap_ = 0.0;
  std::size_t node_count_ = 0;
  std::size_t pixels_ = 0;
  struct Place {
    std::uint32_t surface, index;
  };
  std::vector<Place> places_;  // of the triangles, as the device counts them
  Buffer nodes_, corners_, hits_;
};

}  // namespace brume::gl
