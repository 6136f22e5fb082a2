#pragma once

#include <QObject>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "render/error_estimate.h"

namespace brume {

struct RenderedFrame;

// Measures how wrong a frame is, in a thread of its own beside that of the renderer.
class ErrorMeter : public QObject {
  Q_OBJECT
 public:
  explicit ErrorMeter(QObject* parent = nullptr);
  ~ErrorMeter() override;  // gives up

  // Instead of what is being measured. Equal seeds give equal pixels of equal frames.
  void measure(std::shared_ptr<const RenderedFrame> frame, std::uint64_t seed);
  // Does not wait: the thread is free within the reference's time for a pixel.
  void cancel();

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
  void work(const std::stop_token& quit);

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Job> pending_;
  std::stop_source stop_job_;
  std::jthread thread_;
};

}  // namespace brume
