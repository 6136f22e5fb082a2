#pragma once

#include <QTimer>
#include <functional>

#include "app/tools/brushes/fog_brush_tool.h"
#include "core/authoring/airbrush.h"

namespace brume {

// Sprays particles while the button is down, and freezes them on release. Fixed time steps: the
// result depends on the timestamps of mouse positions, not on the frame rate.
class AirbrushTool : public FogBrushTool {
  Q_OBJECT
 public:
  AirbrushTool(Document& document, View& view);

  [[nodiscard]] const Airbrush& airbrush() const { return airbrush_; }
  void set_airbrush(const Airbrush& airbrush);
  // Sprays behind the painted surface, into a closed mesh.
  void set_inside(bool inside);
  // Monotonic clock in milliseconds; replaceable for replays.
  void set_clock(std::function<qint64()> clock) { clock_ = std::move(clock); }

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  [[nodiscard]] BrushPreset preset() const override;
  void apply_preset(const BrushPreset& preset) override;

 protected:
  [[nodiscard]] double radius() const override { return airbrush_.radius; }
  [[nodiscard]] double density() const override { return airbrush_.density; }
  // Fog that fills a mesh begins at its surface.
  [[nodiscard]] double offset() const override { return inside_ ? 0.0 : airbrush_.radius; }
  void set_gaussian(double radius, double density) override;
  void set_stretch(double stretch) override { airbrush_.stretch = stretch; }
  void fit_to(double distance) override;
  void begin_stroke(QPointF position) override;
  void extend_stroke(std::span<const QPointF> curve) override;
  void end_stroke() override;

 private:
  void spray();  // up to the current time
  // At a fraction of its path, from 0 to 1.
  [[nodiscard]] std::optional<Nozzle> nozzle_at(double fraction);

  Airbrush airbrush_;
  bool inside_ = false;
  QTimer timer_;
  std::function<qint64()> clock_;
  qint64 begun_ = 0;  // by the clock
  qint64 steps_ = 0;  // time steps done
  std::optional<Spray> spray_;
  // Path of the nozzle since the last step.
  std::vector<QPointF> way_;
  std::vector<GaussianId> ids_;  // of this stroke's Gaussians
};

}  // namespace brume
