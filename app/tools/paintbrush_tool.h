#pragma once

#include "app/tools/brush_tool.h"
#include "core/authoring/paintbrush.h"

namespace brume {

// Paints Gaussians along a stroke.
class PaintbrushTool : public BrushTool {
  Q_OBJECT
 public:
  PaintbrushTool(Document& document, Viewport& viewport);

  [[nodiscard]] const Paintbrush& brush() const { return brush_; }
  void set_brush(const Paintbrush& brush);
  void set_plane(PaintPlane plane);

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  [[nodiscard]] bool takes_alt() const override { return true; }
  void change_size(double factor) override;
  void change_strength(double factor) override;

 protected:
  [[nodiscard]] double cursor_radius() const override { return brush_.radius; }
  [[nodiscard]] PaintPlane plane() const override { return plane_; }
  void begin_stroke(QPointF position) override;
  void extend_stroke(QPointF position) override;

 private:
  void pick(QPointF position);  // radius and density of the Gaussian seen there
  void fit_to_view();           // a radius that suits the size of another scene

  Paintbrush brush_;
  PaintPlane plane_ = PaintPlane::view;
  int seed_ = 1;
  std::optional<PaintStroke> stroke_;
};

}  // namespace brume
