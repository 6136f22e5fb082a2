#pragma once

#include <memory>
#include <optional>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/gl/gl_renderer.h"
#include "render/job.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// The frames of a scene at moments, for files: on its film, whole, with the radiance transfer it
// needs. For one thread.
class FrameSource {
 public:
  // Without a camera: the scene's own of each moment.
  FrameSource(std::shared_ptr<const Scene> scene, std::optional<Camera> camera,
              const Settings& settings, Backend backend);

  // nullopt when it was stopped. Throws InputError.
  std::optional<Frame> at(double time, const Job& job);

 private:
  std::shared_ptr<const Scene> scene_;
  std::optional<Camera> camera_;
  Settings settings_;
  std::shared_ptr<TransferStore> transfers_ = std::make_shared<TransferStore>();
  std::unique_ptr<FrameRenderer> renderer_;
};

}  // namespace brume
