#pragma once

#include <QPointF>
#include <optional>

#include "app/commands/merge_id.h"
#include "core/scene/scene.h"

namespace brume {

class Document;
struct Overlay;

// Light handles in the view: a sun icon to move a light in the view plane, and a ring to change its
// strength.
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
    std::size_t light = 0;
    bool is_ring = false;
    bool operator==(const Handle&) const = default;
  };
  [[nodiscard]] const std::optional<Handle>& hovered() const { return hovered_; }

 private:
  struct Gesture {
    Handle handle;
    QPointF start;
    PointLight before;
    MergeId merge_id = no_merge;
  };
  [[nodiscard]] std::optional<Handle> pick(const CameraRays& rays, QPointF position) const;

  Document& document_;
  std::optional<Handle> hovered_;
  std::optional<Gesture> gesture_;
};

}  // namespace brume
