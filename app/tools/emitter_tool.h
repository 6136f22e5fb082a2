#pragma once

#include <optional>

#include "app/commands/merge_id.h"
#include "app/view/paint_point.h"
#include "app/view/tool.h"
#include "brume/emitter.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Places and drags particle emitters.
class EmitterTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  [[nodiscard]] QString hint() const override;
  void add_options(QHBoxLayout& row) override;
  void set_target(const PaintTarget& target);
  void hover(QPointF position) override;
  void leave() override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override { drag_.reset(); }
  void draw(Overlay& overlay, const CameraRays& rays) const override;
  [[nodiscard]] bool shows_handles() const override { return false; }
  [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 private:
  void drag_to(QPointF position);
  struct DragState {
    std::size_t emitter = 0;
    QPointF start;
    glm::dvec3 before{0.0};
    MergeId merge_id = no_merge;
  };
  [[nodiscard]] std::optional<std::size_t> pick(QPointF position) const;
  // The place of a new one for a click at a position.
  [[nodiscard]] std::optional<PaintPoint> paint_at(QPointF position) const;

  PaintTarget target_;
  std::optional<QPointF> cursor_;
  std::optional<std::size_t> hovered_;
  std::optional<DragState> drag_;
};

}  // namespace brume
