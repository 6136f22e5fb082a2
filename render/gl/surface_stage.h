#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "brume/revision.h"
#include "render/gl/material_stage.h"
#include "render/gl/sliced_stage.h"

namespace brume::gl {

// Lights whose shadows lie in one word of a pixel.
inline constexpr int light_bits = 32;

// Shading of surfaces on the device.
class SurfaceStage {
 public:
  // Fills `behind` from the mesh's hits. `tables`: optical depth tables of the lights, used if the
  // plan says so. Returns the Gaussian x path pairs evaluated.
  std::uint64_t run(const FrameStages& stages, const FrameContext& work, OpticalDepthTables& tables,
                    DeviceFrame& device);

 private:
  void find_shadows(const FrameContext& work, OpticalDepthTables& lights, std::size_t light_count,
                    DeviceFrame& device);
  std::uint64_t sum_depths(const SurfaceLighting& lighting, DeviceFrame& device);
  void upload_values(const FrameStages& stages, const FrameContext& work,
                     const SurfaceLighting& lighting, const glm::dvec3& center,
                     const Program& program);
  void upload_light(const FrameStages& stages, const FrameContext& work,
                    const SurfaceLighting& lighting, const glm::dvec3& center,
                    const Program& program);

  MaterialStage materials_;
  OpticalDepthTables lights_;  // without tables
  Buffer depths_, totals_, values_, light_, lit_;
  // Content of light_: revisions of the environment's grid (0: none) and of vertex lighting, and
  // the offset of the latter.
  Revision source_revision_ = 0;
  Revision vertex_revision_ = 0;
  std::vector<SurfaceShading> shadings_;
  std::vector<std::shared_ptr<const MeasuredBrdf>> measured_;  // per surface; null: none
  // Offsets per surface: vertex lighting of front and back, average depths, measured material; < 0:
  // none.
  std::vector<std::array<int, 4>> begins_;
};

}  // namespace brume::gl
