#pragma once

#include "app/tools/brushes/fog_brush_tool.h"
#include "core/authoring/paintbrush.h"

namespace brume {

// Paints Gaussians along a stroke.
class PaintbrushTool : public FogBrushTool {
  Q_OBJECT
 public:
  PaintbrushTool(Document& document, View& view);

  [[nodiscard]] const Paintbrush& brush() const { return brush_; }
  void set_brush(const Paintbrush& brush);

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  [[nodiscard]] BrushPreset preset() const override;
  void apply_preset(const BrushPreset& preset) override;

 protected:
  [[nodiscard]] double click_density() const override { return brush_.density * brush_.flow; }
  // `prefix` of the names of the widgets.
  void add_brush_options(QHBoxLayout& row, const QString& prefix);

  [[nodiscard]] double radius() const override { return brush_.radius; }
  [[nodiscard]] double density() const override { return brush_.density; }
  void set_gaussian(double radius, double density) override;
  void set_stretch(double stretch) override { brush_.stretch = stretch; }
  void fit_to(double distance) override;
  void begin_stroke(QPointF position) override;
  void extend_stroke(std::span<const QPointF> curve) override;

 private:
  Paintbrush brush_;
  std::optional<PaintStroke> stroke_;
};

}  // namespace brume
