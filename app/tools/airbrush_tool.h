#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "app/tools/brush_tool.h"
#include "core/authoring/airbrush.h"

namespace brume {

// Sprays particles while the button is down; when it is released they stay where they are.
class AirbrushTool : public BrushTool {
  Q_OBJECT
 public:
  AirbrushTool(Document& document, Viewport& viewport);

  [[nodiscard]] const Airbrush& airbrush() const { return airbrush_; }
  void set_airbrush(const Airbrush& airbrush);
  void set_plane(PaintPlane plane);
  // Whether the fog goes behind the surface that is painted on: into a closed mesh.
  void set_inside(bool inside);

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void change_size(double factor) override;
  void change_strength(double factor) override;

 protected:
  [[nodiscard]] double cursor_radius() const override { return airbrush_.radius; }
  [[nodiscard]] PaintPlane plane() const override { return plane_; }
  void begin_stroke(QPointF position) override;
  void extend_stroke(QPointF position) override;
  void end_stroke() override;

 private:
  void spray();  // as far as time has gone
  void fit_to_view();

  Airbrush airbrush_;
  PaintPlane plane_ = PaintPlane::view;
  bool inside_ = false;
  int seed_ = 1;
  QTimer timer_;
  QElapsedTimer clock_;
  qint64 steps_ = 0;  // of time that have been sprayed
  std::optional<Spray> spray_;
  std::optional<PaintPoint> nozzle_;
  std::vector<GaussianId> ids_;  // of what was sprayed in this stroke
};

}  // namespace brume
