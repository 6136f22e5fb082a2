#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/viewport/error_meter.h"
#include "render/quality_control.h"

namespace brume {

struct FrameRequest;

// The settings that frames are rendered with, and how wrong the one on screen is. With `auto` the
// one decides on the other.
class FrameQuality : public QObject {
  Q_OBJECT
 public:
  explicit FrameQuality(QObject* parent = nullptr);

  // nullopt: auto.
  [[nodiscard]] std::optional<AirlightMethod> airlight() const { return airlight_; }
  void set_airlight(std::optional<AirlightMethod> method);
  // The time that frames show [s].
  void set_time(double time) { time_ = time; }
  // What auto keeps. See QualityControl.
  [[nodiscard]] double max_error() const { return control_.max_error(); }
  void set_max_error(double max_error);

  [[nodiscard]] Settings settings() const;  // of frames at rest
  // The same without the time that frames show.
  [[nodiscard]] Settings settings_at_any_time() const;
  [[nodiscard]] const QualityControl& control() const { return control_; }

  // A frame of this scene that was measured.
  struct Tried {
    Settings settings;
    ErrorEstimate error;
    double milliseconds;
  };
  // Those of auto, from cheap to costly, and that of the method chosen instead.
  [[nodiscard]] std::vector<Tried> tried() const;

  // The last error measured: that of the frame on screen if is_measured().
  [[nodiscard]] const std::optional<ErrorEstimate>& error() const { return error_; }
  [[nodiscard]] bool is_measured() const { return measured_; }
  // Whether auto has found that the bound cannot be held.
  [[nodiscard]] bool is_exhausted() const { return !airlight_ && control_.is_exhausted(); }

  // The picture on screen is no longer what should be seen; nothing is measured any more.
  void picture_changes(const Scene& scene, const Camera& camera);
  void scene_replaced();
  // A full frame with the present settings is on screen: it is measured.
  void frame_shown(std::shared_ptr<const RenderedFrame> frame);
  void stop_measuring();

 Q_SIGNALS:
  void settings_changed();  // frames are due again
  void error_changed();
  void failed(const QString& message);

 private:
  void take(const std::shared_ptr<const RenderedFrame>& frame, const ErrorEstimate& error);

  std::optional<AirlightMethod> airlight_;
  double time_ = 0.0;
  QualityControl control_;
  std::shared_ptr<const RenderedFrame> frame_;  // to be measured
  std::optional<ErrorEstimate> error_;
  std::optional<Tried> chosen_;  // with a method of the user's, of the last picture
  bool measured_ = false;
  ErrorMeter meter_;
};

}  // namespace brume
