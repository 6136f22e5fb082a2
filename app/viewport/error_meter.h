#pragma once

#include <QObject>
#include <cstdint>
#include <memory>

#include "app/job_thread.h"
#include "render/error_estimate.h"

namespace brume {

struct RenderedFrame;

// Measures how wrong a frame is, in a thread of its own beside that of the renderer.
class ErrorMeter : public QObject {
  Q_OBJECT
 public:
  explicit ErrorMeter(QObject* parent = nullptr);

  // Instead of what is being measured. Equal seeds give equal pixels of equal frames.
  void measure(std::shared_ptr<const RenderedFrame> frame, std::uint64_t seed);
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
    std::uint64_t seed = 0;
  };
  void work(const Job& job, const std::stop_token& stop);

  JobThread<Job> thread_;
};

}  // namespace brume
