#pragma once

#include <QPointF>
#include <QPointer>
#include <QString>
#include <memory>

#include "app/view/camera/camera_controller.h"
#include "app/view/shown_handles.h"
#include "core/authoring/contribution.h"
#include "core/scene/camera_rays.h"

namespace brume {

class SurfacePicker;

// The share of the light at a position that a Gaussian has to take to be pointed at there.
inline constexpr double min_pointed_effect = 0.02;

// One view of the document as tools and panels know it: camera, handles, and what is under the
// mouse. Knows nothing of frames.
class View {
 public:
  // `pane`: the widget that shows it.
  View(const Document& document, SurfacePicker& surfaces, Projection projection,
       const QWidget& pane);
  virtual ~View() = default;
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  [[nodiscard]] CameraController& camera_controller() { return camera_; }
  [[nodiscard]] Projection projection() const { return camera_.projection(); }
  [[nodiscard]] const Camera& camera() const { return camera_.camera(); }
  [[nodiscard]] Camera shown_camera() const { return camera_.shown_camera(); }
  [[nodiscard]] Film film() const { return camera_.film(); }
  [[nodiscard]] CameraRays rays() const { return camera_.rays(); }
  [[nodiscard]] double distance() const { return camera_.distance(); }

  [[nodiscard]] ShownHandles& shown_handles() { return handles_; }
  [[nodiscard]] const ShownHandles& shown_handles() const { return handles_; }
  [[nodiscard]] const Handles& handles() const { return handles_.handles(); }
  void set_hovered(std::optional<GaussianId> id) { handles_.set_hovered(id); }
  virtual void show_band(const QRect& rectangle) = 0;  // null: none

  void set_asked(const QObject& menu, QPointF position);

  // Displayed time [s].
  [[nodiscard]] double time() const { return time_; }
  virtual void set_time(double time);
  // The scene at that time, including particles, without hidden Gaussians. Axis views hide
  // homogeneous fog, which would be opaque from so far away.
  [[nodiscard]] std::shared_ptr<const Scene> shown_scene() const;
  // Why it is shown without its sequences; empty: it is not.
  [[nodiscard]] const QString& problem() const { return problem_; }

  // Pivot of tools: the center of the document's object or of the selected Gaussians, or the
  // camera's target.
  [[nodiscard]] glm::dvec3 pivot() const;
  // The position of the mouse in the pane, or else the pane's center; while a menu lives that was
  // asked for at a position, that position.
  [[nodiscard]] QPointF mouse_position() const;
  // The center of a ball that is put under the mouse (paint_point()).
  [[nodiscard]] glm::dvec3 place_under_mouse(double radius);
  // The point seen at a position, unless it is far beyond what is looked at: on the surface, or
  // else in the middle of the fog.
  [[nodiscard]] std::optional<glm::dvec3> point_under(QPointF position);
  // The fog that is shown, on a ray of unit direction.
  [[nodiscard]] FogOnRay fog_on(const glm::dvec3& origin, const glm::dvec3& direction) const;
  // World-space vector of a pixel offset at the pivot's depth.
  [[nodiscard]] glm::dvec3 shift_on_film(QPointF pixels) const;
  // The surface at a position, neither hidden nor locked, if the fog before it lets more than half
  // of its light through: else a click means the fog.
  [[nodiscard]] std::optional<std::size_t> visible_surface(QPointF position);
  // The surface that is so near to the eye, all over the film, that nothing else is seen, as within
  // a wall.
  [[nodiscard]] std::optional<std::size_t> surface_at_eye() const;
  // The unlocked Gaussian that absorbs most light at a position; nullopt if negligible.
  [[nodiscard]] std::optional<GaussianId> max_visible(QPointF position);
  [[nodiscard]] SurfacePicker& surfaces() { return surfaces_; }

 private:
  const Document& document_;
  SurfacePicker& surfaces_;
  const QWidget& pane_;
  CameraController camera_;
  ShownHandles handles_;
  QPointer<const QObject> menu_;
  QPointF asked_;  // where it was
  double time_ = 0.0;
  // Cache of shown_scene() and the snapshot it derives from.
  mutable std::shared_ptr<const Scene> at_time_;
  mutable std::shared_ptr<const Scene> at_time_of_;
  mutable QString problem_;
};

}  // namespace brume
