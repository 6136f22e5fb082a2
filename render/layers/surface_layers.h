#pragma once

#include "brume/scene.h"
#include "core/io/image/image_file.h"
#include "render/util/job.h"

namespace brume {

// Rays per pixel that mattes count. They are filtered as pixels are: see pixel_samples().
inline constexpr int matte_samples = 16;

// A name for each surface: its own, else of its mesh file or its shape; where several have the
// same, the later ones are numbered, "Box (2)".
std::vector<std::string> surface_names(const std::vector<Surface>& surfaces);

// What camera rays hit first, computed on the CPU whatever renders the frame. Sets width and height
// of `image`, and adds of `layers`, as far as they are on:
//   normal     normal.X/Y/Z, unit, in the world, on the side that is seen
//   albedo     albedo.R/G/B, the diffuse reflectance; with that straight on of what shines of a
//              metallic-roughness material; of a measured one 0
//   position   position.X/Y/Z in the world [u]
//   motion     forward.u/v: how far the point moves until the next frame, to the right and up
//              [pixels]; where nothing is hit, the direction
//   objects    CryptoObject00 to 02, by surface_names()
//   materials  CryptoMaterial00 to 02: surfaces of the same material have one name
// All are 0 where nothing is hit, but motion. `next`: the scene a frame later, for motion.
void add_surface_layers(const Scene& scene, const Camera& camera, const Film& film,
                        const OutputLayers& layers, const Scene* next, const Camera& next_camera,
                        const Job& job, ImageLayers& image);

}  // namespace brume
