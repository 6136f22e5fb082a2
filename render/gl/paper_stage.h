#pragma once

#include "render/gl/sliced_stage.h"

namespace brume::gl {

// The paper's airlight on the device.
class PaperStage {
 public:
  // Like SlicedStage::run(). Optical depths to Gaussian centers are computed on the CPU.
  std::size_t run(FrameStages& stages, FrameContext& work, StageClock& clock, DeviceFrame& device);

 private:
  void upload_lights(const PaperLights& paper, std::size_t gaussians, const glm::dvec3& eye);
  void upload_inscattering(const EnvironmentLight& environment);

  FilmAirlight film_;
  Buffer lights_, frozen_, inscattering_;
};

}  // namespace brume::gl
