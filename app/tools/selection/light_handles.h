#pragma once

#include <QPointF>
#include <optional>

#include "app/commands/merge_id.h"
#include "app/document/document.h"
#include "brume/scene.h"
#include "core/scene/camera_rays.h"

namespace brume {

struct Overlay;

// Light handles in the view: a sun icon to move a light in the view plane, and a ring to change its
// strength; a directional light's icon stands beside what is looked at and turns it; of
// a spot or area light the end of its axis to turn it; the rim of a cone to open it, that of a
// surface to scale it. Lights that are neither selected nor under the mouse have the icon, and area
// lights their edge, alone.
class LightHandles {
 public:
  explicit LightHandles(Document& document) : document_(document) {}

  void draw(Overlay& overlay, const CameraRays& rays) const;

  // Hit-tests and highlights a handle.
  bool hover(const CameraRays& rays, QPointF position);
  // Begins a gesture; false if no handle is hit.
  bool press(const CameraRays& rays, QPointF position);
  void move(const CameraRays& rays, QPointF position);
  void end() { gesture_.reset(); }
  void cancel();  // reverts the gesture
  [[nodiscard]] bool is_dragging() const { return gesture_.has_value(); }

  struct Handle {
    enum class Part { light, ring, target, rim };
    std::size_t light = 0;
    Part part = Part::light;
    bool operator==(const Handle&) const = default;
  };
  [[nodiscard]] const std::optional<Handle>& hovered() const { return hovered_; }

 private:
  struct Gesture {
    Handle handle;
    QPointF start;
    Light before;
    MergeId merge_id = no_merge;
  };
  struct DrawnShape;
  // Opens a cone or scales a surface by dragging its rim.
  void open_or_scale(const DrawnShape& shape, double factor);
  [[nodiscard]] bool is_selected(std::size_t light) const {
    return document_.object() == ObjectRef{ObjectRef::Kind::light, light};
  }
  [[nodiscard]] std::optional<Handle> pick(const CameraRays& rays, QPointF position) const;

  Document& document_;
  std::optional<Handle> hovered_;
  std::optional<Gesture> gesture_;
};

}  // namespace brume
