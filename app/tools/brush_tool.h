#pragma once

#include <optional>

#include "app/commands/edit_gesture.h"
#include "app/tools/paint_plane.h"
#include "app/tools/stroke_path.h"
#include "app/view/tool.h"

namespace brume {

// Base of brushes: size, cursor, and a stroke as one undo step.
class BrushTool : public Tool {
  Q_OBJECT
 public:
  BrushTool(Document& document, View& view);

  void hover(QPointF position) override;
  void leave() override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  // Other changes of the medium, such as undo, end the stroke.
  void medium_changed() override;

  void draw(Overlay& overlay, const CameraRays& rays) const override;
  [[nodiscard]] bool shows_handles() const override { return false; }
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 protected:
  // Radius of the cursor's sphere at the paint point [u].
  [[nodiscard]] virtual double cursor_radius() const = 0;
  [[nodiscard]] virtual PaintTarget target() const = 0;
  virtual void begin_stroke(QPointF position) = 0;
  // Extends the stroke by points of a smooth curve; may be empty.
  virtual void extend_stroke(std::span<const QPointF> curve) = 0;
  virtual void end_stroke() {}  // always called

  void end_gesture();

  // The paint point at a position; during a stroke on its initial plane.
  [[nodiscard]] std::optional<PaintPoint> paint_at(QPointF position) const;

  EditGesture gesture_;

 private:
  StrokePath path_;
  std::optional<QPointF> cursor_;
  glm::dvec3 pivot_{0.0};  // of the stroke
};

}  // namespace brume
