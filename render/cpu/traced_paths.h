#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

#include "render/paths/environment_sampler.h"
#include "render/paths/path_film.h"
#include "render/paths/path_medium.h"
#include "render/prepare/frame_stages.h"

namespace brume {

// `path`: airlight, transmittance and surfaces of a frame by path tracing, with what is kept for
// the next frame: samples of the same picture, majorants, the environment's distribution.
class TracedPaths {
 public:
  // Fills the layers of work.frame; returns the outgoing radiance of surfaces per pixel, for
  // composite(). `passing`: see PathFilm::View. If the job is stopped all is incomplete.
  std::span<const glm::vec3> trace(const FrameStages& stages, FrameContext& work,
                                   std::function<float(std::size_t)> passing);

 private:
  void prepare(const FrameStages& stages, const FrameContext& work);

  std::unique_ptr<PathMedium> medium_;
  Revision medium_revision_ = 0;
  std::optional<EnvironmentSampler> environment_;
  PathFilm film_;
};

}  // namespace brume
