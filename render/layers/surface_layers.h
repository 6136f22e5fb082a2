#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "brume/scene.h"
#include "core/io/image/image_file.h"
#include "render/util/job.h"
#include "render/visibility/surface_hit.h"

namespace brume {

// Rays per pixel that mattes count. They are filtered as pixels are: see pixel_samples().
inline constexpr int matte_samples = 16;

// The matte of each surface and of each light that is seen, as an index into their names, which are
// in the order of first use.
struct Mattes {
  std::vector<std::uint32_t> of_surface;
  std::vector<std::uint32_t> of_light;  // by LightShapes; empty of materials
  std::vector<std::string> names;  // where several were the same, the later are numbered, "Box (2)"

  [[nodiscard]] std::uint32_t of(const SurfaceHit& hit) const {
    return hit.is_light() ? of_light[hit.light()]
                          : of_surface[static_cast<std::size_t>(hit.surface)];
  }
};
// Surfaces by name: their own, else that of the mesh file or the shape. The parts of a node of an
// imported scene are one. Lights that are seen by name: their own, else that of their kind.
Mattes object_mattes(const std::vector<Surface>& surfaces, std::span<const Light> lights = {});
// Surfaces by material: the name that the imported file gives it, else its type and a number.
Mattes material_mattes(const std::vector<Surface>& surfaces);

// Layers of the first hits of camera rays, on surfaces and lights that are seen, computed on the
// CPU whatever renders the frame. Sets width and height of `image`, and adds of `layers`, as far as
// they are on:
//   normal     normal.X/Y/Z, unit, in the world, on the side that is seen
//   albedo     albedo.R/G/B, the diffuse reflectance; with that straight on of what shines of a
//              metallic-roughness material; of a measured one 0
//   position   position.X/Y/Z in the world [u]
//   motion     forward.u/v: how far the point moves until the next frame, to the right and up
//              [pixels]; where nothing is hit, the direction
//   objects    CryptoObject00 to 02, of object_mattes()
//   materials  CryptoMaterial00 to 02, of material_mattes(); lights have none
// All are 0 where nothing is hit, but motion. `next`: the scene a frame later, for motion.
void add_surface_layers(const Scene& scene, const Camera& camera, const Film& film,
                        const OutputLayers& layers, const Scene* next, const Camera& next_camera,
                        const Job& job, ImageLayers& image);

}  // namespace brume
