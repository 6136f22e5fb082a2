#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/gl/sliced_stage.h"

namespace brume::gl {

// The light of surfaces on the device.
class SurfaceStage {
 public:
  // Fills `behind` of the textures from the hits of the mesh. `tables`: those of the lights, where
  // depths are taken from; null: they are summed exactly. Returns the Gaussian x path pairs that
  // this took.
  std::uint64_t run(const FrameStages& stages, const FrameWork& work, LightTables* tables,
                    DeviceFrame& device);

 private:
  std::uint64_t sum_depths(const SurfaceLighting& lighting, DeviceFrame& device);
  void upload_values(const FrameStages& stages, const FrameWork& work,
                     const SurfaceLighting& lighting, const glm::dvec3& middle,
                     const Program& program);
  void upload_light(const FrameStages& stages, const FrameWork& work,
                    const SurfaceLighting& lighting, const glm::dvec3& middle,
                    const Program& program);

  LightTables lights_;  // without tables
  Buffer depths_, totals_, values_, light_;
  // What light_ holds: the revisions of an environment's grid, 0 for none, and of light at
  // vertices; and where that of surfaces begins.
  std::uint64_t source_revision_ = 0;
  std::uint64_t vertex_revision_ = 0;
  std::vector<SurfaceShading> shadings_;
  std::vector<std::shared_ptr<const MeasuredBrdf>> measured_;  // of each surface; null: none
  // Of each surface's light at vertices, front and back, of its average depths and its table of a
  // measured material; < 0: there is none.
  std::vector<std::array<int, 4>> begins_;
};

}  // namespace brume::gl
