#pragma once

#include <tbb/task_arena.h>

#include "render/environment_source.h"
#include "render/frame_stages.h"
#include "render/gl/film_airlight.h"
#include "render/gl/light_tables.h"
#include "render/gl/shadow_maps.h"
#include "render/gl/slice_texture.h"

namespace brume::gl {

// What the stages of a frame share while it is made on the device.
struct DeviceFrame {
  Programs& programs;
  DeviceClock& clock;
  MediumBuffers& medium;
  MeshBuffers& mesh;
  TileLists& lists;
  FilmTextures& textures;
  FilmView view;
  tbb::task_arena& arena;  // where the CPU's part runs; OpenGL's does not leave its thread
};

// The sliced airlight on the device, and what it keeps from frame to frame.
class SlicedStage {
 public:
  // Fills the airlight and the pairs of the textures. Returns where the method itself was asked.
  std::size_t run(FrameStages& stages, FrameWork& work, DeviceFrame& device);
  // Of the lights of the last run().
  LightTables& tables() { return lights_; }

 private:
  void make_shadows(const FrameWork& work, std::span<const SlicedLight> lights,
                    std::span<const DirectionMap> tables, DeviceFrame& device);
  void upload_source(const EnvironmentSource* source, const glm::dvec3& eye,
                     const Program& program);

  LightTables lights_;
  ShadowMaps shadows_;
  SliceTexture slices_;
  FilmAirlight film_;
  Buffer source_;
  std::uint64_t source_revision_ = 0;
};

// Sets the uniforms of shaders/noise.glsl.
void set_noise(const Program& program, const RayNoise& noise, const glm::dvec3& eye);

}  // namespace brume::gl
