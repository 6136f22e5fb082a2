#pragma once

#include <QPointF>
#include <optional>

#include "app/commands/merge_id.h"
#include "core/scene/scene.h"

namespace brume {

class Document;
struct Overlay;

// The lights in the view: a sun at each that is dragged to move it across the view, and a ring
// around it that is dragged to make it stronger.
class LightHandles {
 public:
  explicit LightHandles(Document& document) : document_(document) {}

  void draw(Overlay& overlay, const CameraRays& rays) const;

  // Positions are on the film of `rays`.
  // Whether a handle is at the position; the one that is shown as such.
  bool hover(const CameraRays& rays, QPointF position);
  // Whether a gesture has begun.
  bool press(const CameraRays& rays, QPointF position);
  void move(const CameraRays& rays, QPointF position);
  void end() { gesture_.reset(); }
  void cancel();  // as if it had not begun
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
