#pragma once

#include "app/tools/brushes/brush_tool.h"
#include "core/authoring/eraser.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Reduces density under the cursor at any depth.
class EraserTool : public BrushTool {
  Q_OBJECT
 public:
  using BrushTool::BrushTool;

  [[nodiscard]] double radius() const { return radius_; }      // on the film [pixels]
  [[nodiscard]] double strength() const { return strength_; }  // of one touch, in (0, 1]

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void change_size(double factor) override;
  void change_strength(double factor) override;
  void draw_on_film(Overlay& overlay) const override;

 protected:
  void begin_stroke(QPointF position) override;
  void extend_stroke(std::span<const QPointF> curve) override;

 private:
  void set(double radius, double strength);
  void touch(const std::vector<QPointF>& places);
  [[nodiscard]] double cone_slope(const CameraRays& rays) const;

  double radius_ = 40.0;
  double strength_ = 0.3;
  std::optional<EraserStroke> stroke_;
  QPointF last_touch_;
};

}  // namespace brume
