#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/job_thread.h"
#include "render/frame_errors.h"

namespace brume {

struct RenderedFrame;

// Measures how wrong a frame is, in a thread of its own beside that of the renderer.
class ErrorMeter : public QObject {
  Q_OBJECT
 public:
  explicit ErrorMeter(QObject* parent = nullptr);

  // Instead of what is being measured. `max_error` as of FrameErrors; frames of one view are
  // measured on the same pixels.
  void measure(std::shared_ptr<const RenderedFrame> frame, std::optional<double> max_error);
  // Does not wait: the thread is free within the reference's time for a pixel.
  void cancel() { thread_.cancel(); }

 Q_SIGNALS:
  // May still come, once, for a frame that was cancelled just before.
  void measured(std::shared_ptr<const brume::RenderedFrame> frame,
                const brume::ErrorEstimate& error);
  void failed(const QString& message);

 private:
  struct Job {
    std::shared_ptr<const RenderedFrame> frame;
    std::optional<double> max_error;
  };
  void work(const Job& job, const std::stop_token& stop);
  FrameErrors& errors_of_view(const std::shared_ptr<const RenderedFrame>& frame);

  // Of the thread: the view that was measured last.
  std::shared_ptr<const Scene> scene_;
  Camera camera_;
  Film film_;
  double time_ = 0.0;
  std::optional<FrameErrors> errors_;
  JobThread<Job> thread_;
};

}  // namespace brume
