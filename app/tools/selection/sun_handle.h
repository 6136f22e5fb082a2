#pragma once

#include <QColor>
#include <QPointF>
#include <optional>

#include "app/commands/merge_id.h"
#include "brume/lights.h"
#include "core/scene/camera_rays.h"

namespace brume {

class Document;
struct Overlay;

// The icon of lights: a circle of sun_radius() and rays.
double sun_radius();  // pixels
void draw_sun_icon(Overlay& overlay, QPointF place, QRgb color, bool hovered);

// The sun of a scene's sky, an icon where it stands in the sky, which drags it; it may be dragged
// below the horizon. Behind the eye, and in views without perspective, there is none.
class SunHandle {
 public:
  explicit SunHandle(Document& document) : document_(document) {}

  void draw(Overlay& overlay, const CameraRays& rays) const;

  bool hover(const CameraRays& rays, QPointF position);
  [[nodiscard]] bool is_hovered() const { return is_hovered_; }
  // Begins a gesture; false if the sun is elsewhere.
  bool press(const CameraRays& rays, QPointF position);
  void move(const CameraRays& rays, QPointF position);
  void end() { gesture_.reset(); }
  void cancel();  // reverts the gesture
  [[nodiscard]] bool is_dragging() const { return gesture_.has_value(); }

 private:
  struct Gesture {
    QPointF offset;  // of the sun from the mouse
    Environment before;
    MergeId merge_id = no_merge;
  };

  // The unit direction to it; nullopt without a sky.
  [[nodiscard]] std::optional<glm::dvec3> direction() const;
  [[nodiscard]] std::optional<QPointF> place(const CameraRays& rays) const;

  Document& document_;
  bool is_hovered_ = false;
  std::optional<Gesture> gesture_;
};

}  // namespace brume
