#pragma once

#include "render/gl/sliced_stage.h"

namespace brume::gl {

// The paper's airlight on the device.
class PaperStage {
 public:
  // As SlicedStage::run(). What takes light on its way to centres of Gaussians is the CPU's.
  std::size_t run(FrameStages& stages, FrameWork& work, StageClock& clock, DeviceFrame& device);

 private:
  void upload_lights(const PaperLights& paper, std::size_t gaussians, const glm::dvec3& eye);
  void upload_glow(const EnvironmentLight& environment);

  FilmAirlight film_;
  Buffer lights_, frozen_, glow_;
};

}  // namespace brume::gl
