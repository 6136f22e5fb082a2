#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brume/frame.h"
#include "brume/revision.h"
#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/ray_noise.h"
#include "render/paths/path_sums.h"
#include "render/paths/path_tracer.h"
#include "render/util/job.h"

namespace brume {

// Identifies the frame that samples are of: while it stays, more of them can be added.
struct PathKey {
  Revision medium = 0;  // of the MediumIndex
  RayNoise noise;
  double albedo = 1.0;
  std::vector<PointLight> lights;
  std::optional<Environment> environment;
  std::vector<Surface> surfaces;
  std::vector<LightShape> light_shapes;
  FogBall fog;
  bool is_fog_everywhere = true;
  Camera camera;
  Film film;
  glm::dvec3 channels{1.0};
  std::uint64_t seed = 0;
  bool is_mirrored_alone = false;  // PathScene's

  bool operator==(const PathKey&) const = default;
};

// The sums of all pixels of a film, kept from one frame to the next: a frame of more paths traces
// only those that are missing, and is the same to the last bit as one made at once. 64 bytes per
// pixel with a medium, 64 more with surfaces.
class PathFilm {
 public:
  struct View {
    const PathScene& scene;
    const CameraRays& rays;
    CameraRays::PixelRectangle pixels;  // that are traced
    double open_end;                    // of rays that hit nothing [u], may be +inf
    // First hit of a pixel's ray.
    std::function<SurfaceHit(std::size_t pixel)> hit;
    // Share of its light that the eye gets, of what is behind panes; pixels with 0 are not traced.
    // Empty: all of it.
    std::function<float(std::size_t pixel)> passing{};
    int paths;          // per pixel; 0: transmittance alone
    bool has_medium;    // airlight and transmittance are wanted
    bool has_surfaces;  // their radiance is
  };

  // Fills airlight, transmittance and pairs per pixel of the frame, whose layers must be allocated,
  // and adds to its noise. If the job is stopped the frame is incomplete, and what was traced is
  // kept.
  void trace(const PathKey& key, const View& view, const Job& job, Frame& frame);

  // Outgoing radiance of surfaces per pixel, before the medium in front; empty without surfaces.
  [[nodiscard]] std::span<const glm::vec3> surfaces() const { return surface_radiance_; }

  // Pixels that a thread traces at once.
  static constexpr std::size_t run = 16;

 private:
  struct Variances {
    double airlight = 0.0;
    double surfaces = 0.0;
  };
  void trace_pixel(const View& view, const PathTracer& tracer, const glm::ivec2& position,
                   const Job& job, Frame& frame, Variances& variances);

  PathKey key_;
  int paths_ = 0;            // requested last
  std::vector<int> counts_;  // of paths, per pixel
  std::vector<PathSums> airlight_;
  std::vector<PathSums> surfaces_;
  std::vector<glm::vec3> surface_radiance_;
};

}  // namespace brume
