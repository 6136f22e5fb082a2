#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "brume/frame.h"
#include "brume/scene.h"
#include "core/io/image/image_file.h"
#include "render/gl_renderer.h"
#include "render/output/frame_file.h"
#include "render/samples/exposure.h"
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
              const Settings& settings, const Exposure& exposure, Backend backend);

  // nullopt if stopped. Throws InputError.
  std::optional<Frame> at(double time, const Job& job);
  // More layers of a frame of at(), see render_layers(). nullopt if stopped.
  std::optional<ImageLayers> layers(Frame& frame, const OutputLayers& layers, const Job& job);
  // Writes what a frame of at() shows as a deep file. False if stopped. Throws InputError.
  bool write_deep(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info,
                  const Job& job);

 private:
  std::shared_ptr<const Scene> scene_;
  std::optional<Camera> camera_;
  Film film_;
  Settings settings_;
  Exposure exposure_;
  std::shared_ptr<TransferStore> transfers_ = std::make_shared<TransferStore>();
  std::unique_ptr<FrameRenderer> renderer_;
};

}  // namespace brume
