#include "app/frames/error_meter.h"

#include "app/frames/frame_service.h"
#include "render/quality/auto_quality.h"

namespace brume {

ErrorMeter::ErrorMeter(QObject* parent) : QObject(parent) {
  connect(&job_, &BackgroundJob::failed, this, &ErrorMeter::failed);
}

void ErrorMeter::measure(const std::shared_ptr<const RenderedFrame>& frame,
                         std::optional<double> max_error) {
  job_.start([this, frame, max_error](const Job& job) -> BackgroundJob::Apply {
    const auto found = errors_of_view(*frame).measure(frame->frame, max_error, job.stop);
    if (!found) return {};
    return [this, frame, error = *found] { Q_EMIT measured(frame, error); };
  });
}

FrameErrors& ErrorMeter::errors_of_view(const RenderedFrame& frame) {
  const FrameRequest& request = frame.request;
  if (!errors_ || request.scene != scene_ || request.camera != camera_ ||
      frame.frame.film != film_) {
    scene_ = request.scene;
    camera_ = request.camera;
    film_ = frame.frame.film;
    errors_.emplace(*scene_, camera_, evaluation_seed, Measured::airlight_and_picture);
  }
  return *errors_;
}

}  // namespace brume
