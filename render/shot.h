#pragma once

#include <optional>

#include "brume/scene.h"
#include "render/quality/auto_quality.h"
#include "render/samples/exposure.h"
#include "render/util/job.h"

namespace brume {

// What a frame is made from, which lives as long.
struct Shot {
  const Scene& animation;
  const Scene& scene;            // of the animation at a time
  std::optional<Camera> camera;  // absent: the scene's, of each moment
  Film film;
  Exposure exposure;
  bool measures_error = true;  // of `auto`

  [[nodiscard]] const Camera& seen_by() const { return camera ? *camera : scene.camera; }
  // The scene at that moment and others.
  [[nodiscard]] SceneAt moments() const;
};

// Renders it as exposed. With `auto_`, settings are chosen, and the error is measured, if it is to
// be, of a frame without blur. nullopt if stopped.
std::optional<RequestedFrame> render_shot(FrameRenderer& renderer, const Shot& shot,
                                          Settings settings, const Job& job = {});

}  // namespace brume
