#pragma once

#include <QTimer>
#include <functional>

#include "app/tools/fog_brush_tool.h"
#include "core/authoring/airbrush.h"

namespace brume {

// Sprays particles while the button is down; when it is released they stay where they are. Time
// goes in steps of one length: what comes out depends on when, by the clock, the mouse was where,
// and not on how often pictures came.
class AirbrushTool : public FogBrushTool {
  Q_OBJECT
 public:
  AirbrushTool(Document& document, Viewport& view);

  [[nodiscard]] const Airbrush& airbrush() const { return airbrush_; }
  void set_airbrush(const Airbrush& airbrush);
  // Whether the fog goes behind the surface that is painted on: into a closed mesh.
  void set_inside(bool inside);
  // Milliseconds that never go back; a replay has its own.
  void set_clock(std::function<qint64()> clock) { clock_ = std::move(clock); }

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;

 protected:
  [[nodiscard]] double radius() const override { return airbrush_.radius; }
  [[nodiscard]] double density() const override { return airbrush_.density; }
  void set_gaussian(double radius, double density) override;
  void fit_to(double distance) override;
  void begin_stroke(QPointF position) override;
  void extend_stroke(std::span<const QPointF> curve) override;
  void end_stroke() override;

 private:
  void spray();  // as far as time has gone
  // At a part of its way, from 0 to 1.
  [[nodiscard]] std::optional<Nozzle> nozzle_at(double part) const;

  Airbrush airbrush_;
  bool inside_ = false;
  QTimer timer_;
  std::function<qint64()> clock_;
  qint64 begun_ = 0;  // by the clock
  qint64 steps_ = 0;  // of time that have been sprayed
  std::optional<Spray> spray_;
  // Where the nozzle was since the last step that was sprayed.
  std::vector<QPointF> way_;
  std::vector<GaussianId> ids_;  // of what was sprayed in this stroke
};

}  // namespace brume
