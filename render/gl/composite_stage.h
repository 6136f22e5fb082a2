#pragma once

#include <cstdint>
#include <memory>

#include "render/gl/display_options.h"
#include "render/gl/film_airlight.h"
#include "render/gl/mesh_buffers.h"
#include "render/prepare/albedo.h"
#include "render/prepare/frame_stages.h"

namespace brume::gl {

// Compositing of medium, surfaces and environment on the device.
class CompositeStage {
 public:
  // Fills the `beauty` texture from the others, and the hits of the mesh.
  void run(Programs& programs, const FrameContext& work, MeshBuffers& mesh, FilmTextures& textures);

 private:
  std::shared_ptr<const RadianceMap> map_;  // content of sky_
  Buffer sky_;
  Buffer held_out_;
};

// to_display() on the device.
class DisplayStage {
 public:
  // Writes the channels of a group; after the last the picture is complete. `first_pixel`: where
  // the film begins in the whole picture; `picture`: rgba8.
  void run(Programs& programs, const FilmTextures& film, const DisplayOptions& options,
           const glm::ivec2& first_pixel, const AlbedoGroup& group, bool is_first, bool is_last,
           const Texture& picture);
  // Total Gaussian x ray pairs of all pixels. Waits for the device.
  std::uint64_t sum_pairs(Programs& programs, const FilmTextures& film);

 private:
  Texture channels_;  // accumulates the groups
  Buffer rows_;
};

}  // namespace brume::gl
