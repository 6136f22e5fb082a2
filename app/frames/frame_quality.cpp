#include "app/frames/frame_quality.h"

#include "app/frames/frame_service.h"
#include "render/request.h"

namespace brume {
namespace {

// The reference prepares so many for seconds on all cores, and cannot be stopped: it waits
// until nobody seems to go on.
constexpr std::size_t many_gaussians = 100'000;
constexpr int measure_after = 4000;  // milliseconds

// Airlight is interpolated where that is good enough: the picture is there several times sooner.
constexpr int interpolated_scale = 4;

Settings interpolated(Scattering scattering) {
  return settings_of({.scattering = scattering, .airlight_scale = interpolated_scale});
}

}  // namespace

FrameQuality::FrameQuality(QObject* parent) : QObject(parent), control_(interpolated(scattering_)) {
  connect(&meter_, &ErrorMeter::measured, this, &FrameQuality::set_measured);
  connect(&meter_, &ErrorMeter::failed, this, &FrameQuality::failed);
  wait_.setSingleShot(true);
  wait_.setInterval(measure_after);
  connect(&wait_, &QTimer::timeout, this, &FrameQuality::measure);
}

void FrameQuality::set_airlight(AirlightMethod method, int slices) {
  if (method == airlight_ && slices == slices_) return;
  airlight_ = method;
  slices_ = slices;
  stop_measuring();
  error_.reset();  // not even a hint of the new one
  chosen_.reset();
  Q_EMIT settings_changed();
}

void FrameQuality::set_scattering(Scattering scattering) {
  if (scattering == scattering_) return;
  scattering_ = scattering;
  // The measurement is about other light.
  const double max_error = control_.max_error();
  control_ = QualityControl(interpolated(scattering));
  control_.set_max_error(max_error);
  stop_measuring();
  error_.reset();
  chosen_.reset();
  Q_EMIT settings_changed();
}

void FrameQuality::set_max_error(double max_error) {
  if (max_error == control_.max_error()) return;
  const Settings before = settings();
  control_.set_max_error(max_error);
  if (settings() != before) {
    stop_measuring();
    Q_EMIT settings_changed();
  }
  Q_EMIT error_changed();
}

RenderRequest FrameQuality::request() const {
  RenderRequest request;
  request.airlight = is_auto() ? AirlightMethod::sliced : airlight_;
  request.slices = is_auto() ? control_.settings().slices : slices_;
  request.scattering = scattering_;
  if (airlight_ != AirlightMethod::reference) request.airlight_scale = interpolated_scale;
  return request;
}

Settings FrameQuality::settings() const {
  return settings_of(request());
}

std::vector<FrameQuality::Tried> FrameQuality::tried() const {
  std::vector<Tried> result;
  for (const QualityControl::Trial& trial : control_.trials()) {
    if (trial.error) result.push_back({trial.settings, *trial.error, trial.milliseconds});
  }
  if (chosen_) result.push_back(*chosen_);
  return result;
}

void FrameQuality::picture_changes(const Scene& scene, const Camera& camera) {
  stop_measuring();
  chosen_.reset();
  control_.begin_frame(scene, camera);
}

void FrameQuality::scene_replaced() {
  stop_measuring();
  error_.reset();
  control_.reset();
}

void FrameQuality::frame_shown(std::shared_ptr<const RenderedFrame> frame) {
  stop_measuring();
  frame_ = std::move(frame);
  if (frame_->request.scene->medium.size() < many_gaussians) {
    measure();
  } else {
    wait_.start();
  }
}

void FrameQuality::measure() {
  const std::optional<double> max_error =
      is_auto() ? std::optional(control_.max_error()) : std::nullopt;
  meter_.measure(frame_, max_error);
}

void FrameQuality::set_measured(const std::shared_ptr<const RenderedFrame>& frame,
                                const FrameError& error) {
  if (frame != frame_) return;  // cancelled meanwhile
  frame_.reset();
  error_ = error;
  Settings used = frame->request.settings;
  // They mean nothing to the error, which is that of centers.
  used.samples = settings().samples;
  used.background_apart = settings().background_apart;
  if (is_auto()) {
    control_.record(used, error.airlight, frame->milliseconds);
  } else {
    chosen_ = {used, error.airlight, frame->milliseconds};
  }
  measured_ = settings() == used;
  if (!measured_) Q_EMIT settings_changed();
  Q_EMIT error_changed();
}

void FrameQuality::stop_measuring() {
  wait_.stop();
  meter_.cancel();
  frame_.reset();
  measured_ = false;
}

}  // namespace brume
