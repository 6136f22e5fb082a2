#include "app/viewport/error_meter.h"

#include <exception>

#include "app/viewport/frame_service.h"
#include "render/auto_quality.h"

namespace brume {

ErrorMeter::ErrorMeter(QObject* parent)
    : QObject(parent),
      thread_([this](const Job& job, const std::stop_token& stop) { work(job, stop); }) {}

void ErrorMeter::measure(std::shared_ptr<const RenderedFrame> frame, std::uint64_t seed) {
  thread_.start({std::move(frame), seed});
}

void ErrorMeter::work(const Job& job, const std::stop_token& stop) {
  try {
    const FrameRequest& request = job.frame->request;
    const auto sample =
        take_error_sample(*request.scene, request.camera, job.frame->frame, job.seed, stop);
    if (!sample) return;
    const ErrorEstimate error = sample->measure(job.frame->frame);
    QMetaObject::invokeMethod(
        this, [this, frame = job.frame, error] { Q_EMIT measured(frame, error); },
        Qt::QueuedConnection);
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    QMetaObject::invokeMethod(
        this, [this, message] { Q_EMIT failed(message); }, Qt::QueuedConnection);
  }
}

}  // namespace brume
