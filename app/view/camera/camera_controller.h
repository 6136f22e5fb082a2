#pragma once

#include <QObject>
#include <QPointF>
#include <QRectF>
#include <optional>

#include "app/view/camera/axis_view.h"
#include "app/view/camera/navigation.h"
#include "core/scene/camera_rays.h"

class QWidget;

namespace brume {

class Document;
class SurfacePicker;

// The camera of a view, within the limits of scene files. Its moves are not undoable. Axis views
// pan and zoom but do not orbit.
//
// Surfaces that come between the eye and the room that it looks at while it moves are not shown,
// until the way to where it was is free again or it turns away.
//
// It can look through the scene's camera: it follows that until it is moved. If it is locked to it,
// navigation asks for moves of the scene's camera instead.
class CameraController : public QObject {
  Q_OBJECT
 public:
  // `pane`: its size is the film's.
  CameraController(const Document& document, SurfacePicker& surfaces, Projection projection,
                   const QWidget& pane);

  [[nodiscard]] Projection projection() const { return projection_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  // The camera of the pane's picture: wider than camera() if the scene's film is shown within it,
  // and without walls before the room.
  [[nodiscard]] Camera shown_camera() const;
  [[nodiscard]] bool leaves_out_walls() const { return inside_.has_value(); }
  // Ignores cameras outside the limits. Leaves the scene's camera.
  void set_camera(const Camera& camera);
  // In widget coordinates.
  [[nodiscard]] Film film() const;
  [[nodiscard]] CameraRays rays() const { return {shown_camera(), film()}; }

  void look_through_scene_camera();
  [[nodiscard]] bool looks_through_scene_camera() const { return through_; }
  void set_locked(bool locked) { locked_ = locked; }
  void set_frame_shown(bool shown);
  // The scene's film in the pane; nullopt if it is not shown.
  [[nodiscard]] std::optional<QRectF> frame() const;

  // Equivalent distance of a camera with the default field of view [u]; scales the sizes of new
  // objects.
  [[nodiscard]] double distance() const;

  void reset();  // the scene's camera; axis views: frames all Gaussians
  void frame_all();
  void frame_selection();  // all if nothing is selected
  void frame(const Sphere& sphere);
  void zoom_by(double factor);                       // scales the distance
  void drag(NavigationDrag drag, QPointF movement);  // in pixels
  // Sets the point that drags orbit from now on; nullopt: the target.
  void set_pivot(const std::optional<glm::dvec3>& pivot) { pivot_ = pivot; }
  // Axis views and orthographic cameras have no place to fly from.
  [[nodiscard]] bool can_fly() const;
  void look_around(QPointF movement);  // in pixels
  // The way goes right, up and forth, each times the distance.
  void fly(const glm::dvec3& way);

  void set_navigation(NavigationPreset preset) { navigation_ = preset; }
  [[nodiscard]] NavigationPreset navigation() const { return navigation_; }

 Q_SIGNALS:
  void moved();
  void scene_camera_asked_for(const brume::Camera& camera);

 private:
  void navigate_to(const Camera& camera);
  void show(const Camera& camera);
  void follow_scene();
  // How many times the pane shows the height of camera().
  [[nodiscard]] double margin() const;

  const Document& document_;
  SurfacePicker& surfaces_;
  const Projection projection_;
  const QWidget& pane_;
  Camera camera_;
  std::optional<glm::dvec3> pivot_;
  // Walls that are left out, and the camera before they were on the way.
  std::array<ClipPlane, 4> walls_{};
  std::optional<Camera> inside_;
  bool through_ = false;  // the scene's camera
  bool locked_ = false;
  bool shows_frame_ = true;
  Film scene_film_;  // that frame() was last of
  NavigationPreset navigation_ = NavigationPreset::brume;
};

}  // namespace brume
