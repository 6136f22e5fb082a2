#pragma once

#include <optional>

#include "app/commands/gaussians/edit_gesture.h"
#include "app/tools/stroke_path.h"
#include "app/view/tool.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Base of brushes: where the brush is, and a stroke as one undo step.
class BrushTool : public Tool {
  Q_OBJECT
 public:
  BrushTool(Document& document, View& view);

  void hover(QPointF position) override;
  void leave() override;
  void set_pressure(double pressure) override { pressure_ = pressure; }
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  // Other changes of the medium, such as undo, end the stroke.
  void medium_changed() override;

  [[nodiscard]] bool shows_handles() const override { return false; }
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  [[nodiscard]] bool draws_strokes() const override { return true; }

 protected:
  virtual void begin_stroke(QPointF position) = 0;
  // Extends the stroke by points of a smooth curve; may be empty.
  virtual void extend_stroke(std::span<const QPointF> curve) = 0;
  virtual void end_stroke() {}  // always called

  // How far the brush trails behind the mouse, as if pulled by a string; 0: not at all [pixels].
  [[nodiscard]] virtual double smoothing() const { return 0.0; }
  // Pressure of the pen at a fraction of the curve given to extend_stroke(), from 0 to 1.
  [[nodiscard]] double pressure_at(double fraction) const {
    return pressure_before_ + fraction * (pressure_ - pressure_before_);
  }
  // Where a stroke's brush, or else the mouse is.
  [[nodiscard]] const std::optional<QPointF>& cursor_position() const { return cursor_; }

  void end_gesture();

  EditGesture gesture_;

 private:
  StrokePath path_;
  std::optional<QPointF> cursor_;
  QPointF brush_;  // of the stroke, behind the mouse
  double pressure_ = 1.0;
  double pressure_before_ = 1.0;  // at the end of the last extend_stroke()
};

}  // namespace brume
