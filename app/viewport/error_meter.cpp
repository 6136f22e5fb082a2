#include "app/viewport/error_meter.h"

#include <exception>

#include "app/viewport/frame_service.h"
#include "render/auto_quality.h"

namespace brume {

ErrorMeter::ErrorMeter(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& quit) { work(quit); }) {}

ErrorMeter::~ErrorMeter() {
  thread_.request_stop();
  cancel();
  thread_.join();
}

void ErrorMeter::measure(std::shared_ptr<const RenderedFrame> frame, std::uint64_t seed) {
  const std::scoped_lock lock(mutex_);
  stop_job_.request_stop();
  pending_ = Job{std::move(frame), seed};
  wake_.notify_one();
}

void ErrorMeter::cancel() {
  const std::scoped_lock lock(mutex_);
  stop_job_.request_stop();
  pending_.reset();
}

void ErrorMeter::work(const std::stop_token& quit) {
  while (true) {
    Job job;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, quit, [this] { return pending_.has_value(); })) return;
      job = std::move(*pending_);
      pending_.reset();
      stop_job_ = std::stop_source();
      if (quit.stop_requested()) return;
      stop = stop_job_.get_token();
    }
    try {
      const FrameRequest& request = job.frame->request;
      const auto sample =
          take_error_sample(*request.scene, request.camera, job.frame->frame, job.seed, stop);
      if (!sample) continue;
      const ErrorEstimate error = sample->measure(job.frame->frame);
      QMetaObject::invokeMethod(
          this, [this, frame = std::move(job.frame), error] { Q_EMIT measured(frame, error); },
          Qt::QueuedConnection);
    } catch (const std::exception& error) {
      const QString message = QString::fromUtf8(error.what());
      QMetaObject::invokeMethod(
          this, [this, message] { Q_EMIT failed(message); }, Qt::QueuedConnection);
    }
  }
}

}  // namespace brume
