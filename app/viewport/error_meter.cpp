#include "app/viewport/error_meter.h"

#include <exception>

#include "app/viewport/frame_service.h"
#include "render/quality/auto_quality.h"

namespace brume {

ErrorMeter::ErrorMeter(QObject* parent)
    : QObject(parent),
      thread_([this](const Job& job, const std::stop_token& stop) { work(job, stop); }) {}

void ErrorMeter::measure(std::shared_ptr<const RenderedFrame> frame,
                         std::optional<double> max_error) {
  thread_.start({std::move(frame), max_error});
}

FrameErrors& ErrorMeter::errors_of_view(const std::shared_ptr<const RenderedFrame>& frame) {
  const FrameRequest& request = frame->request;
  if (!errors_ || request.scene != scene_ || request.camera != camera_ ||
      frame->frame.film != film_) {
    scene_ = request.scene;
    camera_ = request.camera;
    film_ = frame->frame.film;
    errors_.emplace(*scene_, camera_, evaluation_seed);
  }
  return *errors_;
}

void ErrorMeter::work(const Job& job, const std::stop_token& stop) {
  try {
    const std::optional<ErrorEstimate> found =
        errors_of_view(job.frame).measure(job.frame->frame, job.max_error, stop);
    if (!found) return;
    QMetaObject::invokeMethod(
        this, [this, frame = job.frame, error = *found] { Q_EMIT measured(frame, error); },
        Qt::QueuedConnection);
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    QMetaObject::invokeMethod(
        this, [this, message] { Q_EMIT failed(message); }, Qt::QueuedConnection);
  }
}

}  // namespace brume
