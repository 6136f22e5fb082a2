#pragma once

#include <tbb/task_arena.h>
#include <cstddef>
#include <vector>

#include "brume/revision.h"
#include "render/gl/film_airlight.h"
#include "render/gl/optical_depth_tables.h"
#include "render/gl/shadow_maps.h"
#include "render/prepare/frame_stages.h"
#include "render/scattering/source_function.h"

namespace brume::gl {

// Device counterpart of FilmSlices: slice boundaries at nodes between tiles.
class SliceTexture {
 public:
  // Chooses boundaries for the tiles of `lists`; `lights` must be uploaded. `slices` and
  // `light_count` determine their number.
  void choose(Programs& programs, DeviceClock& clock, OpticalDepthTables& lights,
              std::size_t light_count, int slices, TileLists& lists, const FilmView& view,
              const FilmTextures& textures);
  // Binds the inputs of shaders/ray_slices.glsl.
  void bind(const Program& program) const;

  // The boundaries of the last choose(), for tests: per tile, and per node all `stride()` of them;
  // empty where there is no medium.
  [[nodiscard]] std::vector<std::vector<float>> download_tiles() const;
  [[nodiscard]] std::vector<std::vector<float>> download_nodes() const;
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(stride_); }

 private:
  int stride_ = 0;
  glm::ivec2 tiles_{0};
  Buffer chosen_;
  Texture nodes_;
};

// Shared state of the stages of a frame on the device.
struct DeviceFrame {
  Programs& programs;
  DeviceClock& clock;
  MediumBuffers& medium;
  MeshBuffers& mesh;
  TileLists& lists;
  FilmTextures& textures;
  FilmView view;
  tbb::task_arena& arena;  // for work on the CPU; OpenGL calls stay in their thread
};

// The sliced airlight on the device, with its caches.
class SlicedStage {
 public:
  // Fills airlight and pairs. Returns the number of pixels evaluated exactly.
  std::size_t run(FrameStages& stages, FrameContext& work, DeviceFrame& device);
  // Tables of the lights of the last run().
  OpticalDepthTables& tables() { return lights_; }

 private:
  void make_shadows(const FrameStages& stages, const FrameContext& work,
                    std::span<const SlicedLight> lights, std::span<const DirectionMap> tables,
                    DeviceFrame& device);
  void upload_source(const SourceFunction* source, const glm::dvec3& eye, const Program& program);

  OpticalDepthTables lights_;
  ShadowMaps shadows_;
  SliceTexture slices_;
  FilmAirlight film_;
  Buffer source_;
  Revision source_revision_ = 0;
  Revision eye_lobe_revision_ = 0;
};

// Sets the uniforms of shaders/noise.glsl.
void set_noise(const Program& program, const RayNoise& noise, const glm::dvec3& eye);

}  // namespace brume::gl
