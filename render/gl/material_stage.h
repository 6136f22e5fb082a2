#pragma once

#include <optional>
#include <vector>

#include "brume/revision.h"
#include "render/gl/sliced_stage.h"

namespace brume::gl {

// Metallic-roughness materials at the hits of view rays, with their textures, on the device.
class MaterialStage {
 public:
  // Leaves what they are behind the pixels of `behind`: see shaders/materials.glsl. Throws
  // OutOfMemory where the textures do not fit.
  void run(const FrameContext& work, DeviceFrame& device);

 private:
  void upload_materials(const Scene& scene);
  void upload_mesh_values(const Scene& scene, const MeshBuffers& mesh);

  Buffer texels_, mesh_values_, records_;
  // Places among mesh_values_, whose first are the first texture coordinates; 0: no mesh has any.
  std::size_t second_texcoords_at_ = 0;
  std::size_t colors_at_ = 0;
  std::optional<std::vector<Material>> materials_;  // of the surfaces; those in records_
  Revision mesh_ = 0;                               // of mesh_values_
};

}  // namespace brume::gl
