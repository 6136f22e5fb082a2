#pragma once

#include <QPointF>
#include <optional>

#include "app/commands/merge_id.h"
#include "core/scene/scene.h"

namespace brume {

class Document;
class Viewport;
struct Overlay;

// The lights in the view: a sun at each that is dragged to move it across the view, and a ring
// around it that is dragged to make it stronger.
class LightHandles {
 public:
  LightHandles(Document& document, Viewport& viewport) : document_(document), viewport_(viewport) {}

  void draw(Overlay& overlay, const CameraRays& rays) const;

  // Whether a handle is at the position; the one that is shown as such.
  bool hover(QPointF position);
  // Whether a gesture has begun.
  bool press(QPointF position);
  void move(QPointF position);
  void end() { gesture_.reset(); }
  void cancel();  // as if it had not begun
  [[nodiscard]] bool is_dragging() const { return gesture_.has_value(); }

 private:
  struct Handle {
    std::size_t light = 0;
    bool is_ring = false;
    bool operator==(const Handle&) const = default;
  };
  struct Gesture {
    Handle handle;
    QPointF start;
    PointLight before;
    MergeId merge_id = no_merge;
  };
  [[nodiscard]] std::optional<Handle> pick(QPointF position) const;

  Document& document_;
  Viewport& viewport_;
  std::optional<Handle> hovered_;
  std::optional<Gesture> gesture_;
};

}  // namespace brume
