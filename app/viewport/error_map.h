#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/job_thread.h"
#include "core/scene/camera.h"

namespace brume {

struct RenderedFrame;

// How wrong the airlight of a frame is, pixel by pixel: the distance to the reference, rms of RGB,
// over the rms of the frame's airlight, so that its rms over the film is the relative RMSE.
struct ErrorMap {
  Film film;
  std::vector<float> error;  // >= 0, by row from the top
  double done = 0.0;         // share of the pixels; each of the others shows a neighbour's
};

// Computes the map of a frame against the reference, in a thread of its own: first for few pixels,
// then for more and more in between.
class ErrorMapper : public QObject {
  Q_OBJECT
 public:
  explicit ErrorMapper(QObject* parent = nullptr);

  // Instead of the one before.
  void start(std::shared_ptr<const RenderedFrame> frame) { thread_.start(std::move(frame)); }
  void cancel() { thread_.cancel(); }

 Q_SIGNALS:
  // Several times a second. May still come, once, for a frame that was cancelled just before.
  void grown(const std::shared_ptr<const brume::RenderedFrame>& frame,
             const std::shared_ptr<const brume::ErrorMap>& map);
  void failed(const QString& message);

 private:
  void work(const std::shared_ptr<const RenderedFrame>& frame, const std::stop_token& stop);

  JobThread<std::shared_ptr<const RenderedFrame>> thread_;
};

}  // namespace brume
