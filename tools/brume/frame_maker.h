#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "brume/at_time.h"
#include "brume/scene.h"
#include "render/deep/deep_file.h"
#include "render/output/frame_file.h"
#include "render/shot.h"
#include "render/transfer/transfer_store.h"
#include "tools/brume/render_options.h"

namespace brume {

// Renders frames of a scene as the options of brume render ask for them. Keeps what is the same in
// the next frame; no frame depends on those before.
class FrameMaker {
 public:
  // The options live as long.
  FrameMaker(const RenderOptions& options, Scene scene);
  FrameMaker(const FrameMaker&) = delete;
  FrameMaker& operator=(const FrameMaker&) = delete;

  // From now on the scene at a time [s]; makes the radiance transfer that it needs.
  void go_to(double time);
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] double frames_per_second() const { return frame_rate(animation_); }
  [[nodiscard]] const Film& film() const { return film_; }
  [[nodiscard]] double transfer_milliseconds() const { return transfer_milliseconds_; }

  // As the options ask for it, or with given settings and camera. `label`: of its progress line.
  [[nodiscard]] RequestedFrame render(const std::string& label) const;
  [[nodiscard]] RequestedFrame render(const std::string& label, const Settings& settings,
                                      const Camera& camera) const;

  // Adds to a rendered frame what the options ask for: returns more layers, which may change it,
  // and measures its error.
  [[nodiscard]] ImageLayers complete(RequestedFrame& found) const;
  [[nodiscard]] FrameInfo info(const RequestedFrame& found) const;
  // Renders again, to a deep file.
  DeepFileStatistics write_deep(const std::filesystem::path& file, const RequestedFrame& found,
                                const FrameInfo& info) const;

 private:
  [[nodiscard]] Shot shot() const;
  void warn_of_cpu(const FrameStatistics& statistics) const;

  const RenderOptions& options_;
  Scene animation_;
  Settings settings_;
  DisplayLook look_;
  Exposure exposure_;
  Film film_;
  std::shared_ptr<TransferStore> transfers_ = std::make_shared<TransferStore>();
  std::string problem_;  // why the renderer is not that asked for
  std::unique_ptr<FrameRenderer> renderer_;
  std::optional<Scene> scene_;
  double transfer_milliseconds_ = 0.0;
  mutable bool has_warned_ = false;
};

}  // namespace brume
