#pragma once

#include <memory>
#include <optional>

#include "app/jobs/background_job.h"
#include "render/quality/frame_errors.h"

namespace brume {

struct RenderedFrame;

// Estimates a frame's error in a background thread beside the renderer's.
class ErrorMeter : public QObject {
  Q_OBJECT
 public:
  explicit ErrorMeter(QObject* parent = nullptr);

  // Replaces a running measurement. `max_error`: see FrameErrors; frames of one view share their
  // sample pixels.
  void measure(const std::shared_ptr<const RenderedFrame>& frame, std::optional<double> max_error);
  // Returns at once; the thread stops after the current pixel.
  void cancel() { job_.cancel(); }

 Q_SIGNALS:
  void measured(std::shared_ptr<const brume::RenderedFrame> frame, const brume::FrameError& error);
  void failed(const QString& message);

 private:
  FrameErrors& errors_of_view(const RenderedFrame& frame);

  // Used in the thread: the last measured view.
  std::shared_ptr<const Scene> scene_;
  Camera camera_;
  Film film_;
  std::optional<FrameErrors> errors_;
  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
