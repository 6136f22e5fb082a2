#pragma once

#include <cstdint>
#include <vector>

#include "brume/revision.h"
#include "core/scene/camera_rays.h"
#include "render/gl/programs.h"
#include "render/visibility/ray_caster.h"

namespace brume::gl {

// The surfaces of a scene on the device, for ray tracing.
class MeshBuffers {
 public:
  // Uploads them if they have changed.
  void update(const RayCaster& ray_caster);

  [[nodiscard]] Revision revision() const { return revision_; }
  // Binds the storage blocks and sets the uniforms of shaders/trace.glsl.
  void bind(const Program& program);
  // Origin of ray coordinates.
  [[nodiscard]] const glm::dvec3& center() const { return center_; }

  // Traces the view rays; `depth` gets their distances (< 0: none).
  void find_hits(Programs& programs, const CameraRays& rays, const Film& film, Texture& depth);
  // Downloads the hits of the last find_hits(), one per pixel.
  [[nodiscard]] std::vector<SurfaceHit> download_hits() const;
  // The places of triangles, in the order of the device.
  struct Place {
    std::uint32_t surface, index;
  };
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  // A PixelHit per pixel.
  Buffer& hits() { return hits_; }

 private:
  Revision revision_ = 0;  // of the ray caster
  glm::dvec3 center_{0.0};
  double radius_ = 0.0;
  std::size_t node_count_ = 0;
  std::size_t pixels_ = 0;
  std::vector<Place> places_;  // by triangle index on the device
  Buffer nodes_, corners_, hits_;
};

}  // namespace brume::gl
