#pragma once

#include <filesystem>
#include <memory>
#include <thread>

#include "app/job_bar.h"
#include "core/scene/scene.h"
#include "render/frame_file.h"
#include "render/settings.h"

namespace brume {

// Renders a frame to an EXR or PNG file in the background.
class FrameExport : public JobBar {
  Q_OBJECT
 public:
  explicit FrameExport(QWidget* parent = nullptr);
  ~FrameExport() override;  // gives up

  [[nodiscard]] bool is_running() const { return running_; }
  // One at a time. The extension decides the format.
  void start(std::shared_ptr<const Scene> scene, const Camera& camera, const Settings& settings,
             const FrameInfo& info, const std::filesystem::path& file);
  void cancel();

 Q_SIGNALS:
  void finished(const QString& file);
  void cancelled();
  void failed(const QString& message);

 private:
  enum class Outcome { written, cancelled, failed };
  void end(Outcome outcome, const QString& text);

  bool running_ = false;
  std::jthread thread_;
};

}  // namespace brume
