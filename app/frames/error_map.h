#pragma once

#include <memory>
#include <vector>

#include "app/jobs/background_job.h"
#include "brume/camera.h"

namespace brume {

struct RenderedFrame;

// Per-pixel error of a frame's airlight: RGB rms difference from the reference over the frame's rms
// airlight, so its rms over the film is the relative RMSE. Of all orders by paths, whose noise is
// subtracted: what of it is left shows where there is little error.
struct ErrorMap {
  Film film;
  std::vector<float> error;  // >= 0, by row from the top
  double done = 0.0;         // fraction of evaluated pixels; others copy a neighbour
  bool all_orders = false;   // of light that is scattered once and more often
};

// Computes an error map in a background thread, coarse to fine.
class ErrorMapper : public QObject {
  Q_OBJECT
 public:
  explicit ErrorMapper(QObject* parent = nullptr);

  // Replaces a running computation.
  void start(const std::shared_ptr<const RenderedFrame>& frame);
  void cancel() { job_.cancel(); }

 Q_SIGNALS:
  // Emitted several times per second.
  void grown(const std::shared_ptr<const brume::RenderedFrame>& frame,
             const std::shared_ptr<const brume::ErrorMap>& map);
  void failed(const QString& message);

 private:
  void work(const std::shared_ptr<const RenderedFrame>& frame, const Job& job);

  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
