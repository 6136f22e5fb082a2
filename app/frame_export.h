#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "app/job_bar.h"
#include "core/scene/scene.h"
#include "render/frame_file.h"
#include "render/gl/gl_renderer.h"
#include "render/settings.h"

namespace brume {

// What is to be written.
struct FrameExportRequest {
  std::shared_ptr<const Scene> scene;  // with all its times
  std::optional<Camera> camera;        // nullopt: the scene's own of each moment
  Settings settings;                   // whose time is that of a single frame
  FrameInfo info;                      // but for the backend, which each frame tells
  Backend backend = Backend::auto_;
  // The extension decides the format: .exr or .png, or .mp4 of several frames.
  std::filesystem::path file;
  struct Range {
    int first = 0;
    int last = 0;
    double frames_per_second = 30.0;
  };
  std::optional<Range> range;  // nullopt: one frame
};

// The file of a frame of a sequence: "smoke_0012.png" of "smoke.png".
std::filesystem::path numbered_file(const std::filesystem::path& file, int frame);

// Renders a frame, a sequence of them or a video to files in the background. Every file is written
// whole or not at all; of a sequence that is cancelled the frames that are complete stay.
class FrameExport : public JobBar {
  Q_OBJECT
 public:
  explicit FrameExport(QWidget* parent = nullptr);
  ~FrameExport() override;  // gives up

  [[nodiscard]] bool is_running() const { return running_; }
  void start(const FrameExportRequest& request);  // one at a time
  void cancel();

 Q_SIGNALS:
  void finished(const QString& file);
  void cancelled(int written);  // so many files are there
  void failed(const QString& message);

 private:
  enum class Outcome { written, cancelled, failed };
  void end(Outcome outcome, int written, const QString& text);

  bool running_ = false;
  std::jthread thread_;
};

}  // namespace brume
