#pragma once

#include <QPointF>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/object_ref.h"
#include "app/tools/selection/light_handles.h"
#include "app/tools/selection/selection_tool.h"
#include "app/tools/selection/sun_handle.h"
#include "brume/gaussian.h"
#include "core/scene/camera_rays.h"

namespace brume {

// The left mouse button: a click selects, a drag on a selected handle moves the selection in the
// plane parallel to the film through that handle, a drag anywhere else is a selection rectangle.
// A click beside the handles selects what is seen there: a surface through thin fog, an emitter, or
// the Gaussian that takes most light.
class SelectTool : public SelectionTool {
  Q_OBJECT
 public:
  SelectTool(Document& document, View& view)
      : SelectionTool(document, view), lights_(document), sun_(document) {}

  [[nodiscard]] QString hint() const override;
  void hover(QPointF position) override;
  void leave() override;
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  void move(std::span<const QPointF> path) override;
  void release(QPointF position) override;
  void cancel() override;
  void abandon() override;
  // Removing the Gaussians of a gesture ends it.
  void medium_changed() override;
  void draw(Overlay& overlay, const CameraRays& rays) const override;

 private:
  enum class Gesture { none, undecided, moving, band };

  void begin_move();
  void move_selection(QPointF position);
  [[nodiscard]] bool has_moved_gaussians() const;
  [[nodiscard]] glm::dvec3 on_drag_plane(QPointF position) const;
  void set_hovered_object(const std::optional<ObjectRef>& object);

  LightHandles lights_;
  SunHandle sun_;
  std::optional<ObjectRef> hovered_object_;
  Gesture gesture_ = Gesture::none;
  SelectMode area_mode_ = SelectMode::set;   // of a rectangle
  SelectMode click_mode_ = SelectMode::set;  // of a click
  QPointF start_;
  std::optional<GaussianId> pressed_;  // the pressed handle

  // While moving: the moved Gaussians and their original values.
  std::vector<GaussianId> ids_;
  std::vector<Gaussian> gaussians_;
  double depth_ = 0.0;  // of the pressed handle along the view
  MergeId merge_id_ = no_merge;
};

}  // namespace brume
