#pragma once

#include <memory>
#include <optional>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/gl_renderer.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"
#include "render/util/job.h"

namespace brume {

// Renders frames of a scene at given times for export, at full resolution and with radiance
// transfer. Not thread-safe.
class FrameSource {
 public:
  // Without a camera: the scene's camera at each time.
  FrameSource(std::shared_ptr<const Scene> scene, std::optional<Camera> camera, const Film& film,
              const Settings& settings, Backend backend);

  // nullopt if stopped. Throws InputError.
  std::optional<Frame> at(double time, const Job& job);

 private:
  std::shared_ptr<const Scene> scene_;
  std::optional<Camera> camera_;
  Film film_;
  Settings settings_;
  std::shared_ptr<TransferStore> transfers_ = std::make_shared<TransferStore>();
  std::unique_ptr<FrameRenderer> renderer_;
};

}  // namespace brume
