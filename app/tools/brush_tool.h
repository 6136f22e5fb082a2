#pragma once

#include <optional>

#include "app/commands/edit_gesture.h"
#include "app/tools/paint_plane.h"
#include "app/tools/stroke_path.h"
#include "app/tools/tool.h"

namespace brume {

// What paintbrush and eraser have in common: a size, a cursor that shows it, and a stroke that is
// one undo step.
class BrushTool : public Tool {
  Q_OBJECT
 public:
  BrushTool(Document& document, Viewport& view);

  void hover(QPointF position) override;
  void leave() override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  // Whoever else changes the medium during a stroke, say by undo, ends it.
  void medium_changed() override;

  void draw(Overlay& overlay, const CameraRays& rays) const override;
  [[nodiscard]] bool shows_handles() const override { return false; }
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 protected:
  // Of the cursor's ball at the point where it paints [u].
  [[nodiscard]] virtual double cursor_radius() const = 0;
  [[nodiscard]] virtual PaintTarget target() const = 0;
  virtual void begin_stroke(QPointF position) = 0;
  // Along a smooth curve, point by point; may be empty.
  virtual void extend_stroke(std::span<const QPointF> curve) = 0;
  virtual void end_stroke() {}  // however it ended

  void end_gesture();

  // Where the brush paints at a position; during a stroke always on the plane it began on.
  [[nodiscard]] std::optional<PaintPoint> paint_at(QPointF position) const;

  EditGesture gesture_;

 private:
  StrokePath path_;
  std::optional<QPointF> cursor_;
  glm::dvec3 pivot_{0.0};  // of the stroke
};

}  // namespace brume
