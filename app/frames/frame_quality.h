#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/frames/error_meter.h"
#include "brume/render.h"
#include "render/quality/quality_control.h"

namespace brume {

struct FrameRequest;

// Render settings, and the error of the current frame, by which `auto` chooses them.
class FrameQuality : public QObject {
  Q_OBJECT
 public:
  explicit FrameQuality(QObject* parent = nullptr);

  [[nodiscard]] AirlightMethod airlight() const { return airlight_; }
  // `slices`: of a manually chosen `sliced`.
  void set_airlight(AirlightMethod method, int slices = Settings().slices);
  static constexpr int fast_slices = 8;
  [[nodiscard]] bool is_fast() const { return slices_ == fast_slices; }
  [[nodiscard]] int slices() const { return slices_; }
  [[nodiscard]] Scattering scattering() const { return scattering_; }
  void set_scattering(Scattering scattering);
  [[nodiscard]] bool is_auto() const { return airlight_ == AirlightMethod::auto_; }
  // Error bound of auto; see QualityControl.
  [[nodiscard]] double max_error() const { return control_.max_error(); }
  void set_max_error(double max_error);

  // The request for frames at rest, as chosen: its method is never `auto_`.
  [[nodiscard]] RenderRequest request() const;
  [[nodiscard]] Settings settings() const;
  [[nodiscard]] const QualityControl& control() const { return control_; }

  // A measurement in this scene.
  struct Tried {
    Settings settings;
    ErrorEstimate error;  // of the airlight
    double milliseconds;
  };
  // Measurements of auto's settings in order of cost, or of the manually chosen method.
  [[nodiscard]] std::vector<Tried> tried() const;

  // The last measured errors; of the current frame if is_measured().
  [[nodiscard]] const std::optional<FrameError>& error() const { return error_; }
  [[nodiscard]] bool is_measured() const { return measured_; }
  // Whether auto cannot meet the bound.
  [[nodiscard]] bool is_exhausted() const { return is_auto() && control_.is_exhausted(); }

  // The picture is outdated; stops measuring.
  void picture_changes(const Scene& scene, const Camera& camera);
  void scene_replaced();
  // A full frame with the current settings is on screen; starts measuring.
  void frame_shown(std::shared_ptr<const RenderedFrame> frame);
  void stop_measuring();

 Q_SIGNALS:
  void settings_changed();  // frames should be rendered again
  void error_changed();
  void failed(const QString& message);

 private:
  void measure();
  void set_measured(const std::shared_ptr<const RenderedFrame>& frame, const FrameError& error);

  AirlightMethod airlight_ = AirlightMethod::auto_;
  int slices_ = Settings().slices;
  Scattering scattering_ = Scattering::multiple;
  QualityControl control_;
  std::shared_ptr<const RenderedFrame> frame_;  // being measured
  std::optional<FrameError> error_;
  std::optional<Tried> chosen_;  // of a manually chosen method
  bool measured_ = false;
  ErrorMeter meter_;
  QTimer wait_;  // before it
};

}  // namespace brume
