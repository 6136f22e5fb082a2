#pragma once

#include <memory>
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
  void upload_texcoords(const Scene& scene, const MeshBuffers& mesh);

  Buffer texels_, texcoords_, records_;
  std::optional<std::vector<Material>> materials_;  // of the surfaces; those in records_
  Revision mesh_ = 0;                               // of texcoords_
};

}  // namespace brume::gl
