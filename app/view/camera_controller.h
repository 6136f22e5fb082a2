#pragma once

#include <QObject>
#include <QPointF>

#include "app/view/axis_view.h"
#include "app/view/navigation.h"

class QWidget;

namespace brume {

class Document;

// The camera of a view, within the limits of scene files. Its moves are not undoable. Axis views
// pan and zoom but do not orbit.
class CameraController : public QObject {
  Q_OBJECT
 public:
  // `pane`: its size is the film's.
  CameraController(const Document& document, Projection projection, const QWidget& pane);

  [[nodiscard]] Projection projection() const { return projection_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  // Ignores cameras outside the limits.
  void set_camera(const Camera& camera);
  // In widget coordinates.
  [[nodiscard]] Film film() const;
  [[nodiscard]] CameraRays rays() const { return {camera_, film()}; }
  // Equivalent distance of a camera with the default field of view [u]; scales the sizes of new
  // objects.
  [[nodiscard]] double distance() const;

  void reset();  // the scene's camera; axis views: frames all Gaussians
  void frame_all();
  void frame_selection();                            // all if nothing is selected
  void zoom_by(double factor);                       // scales the distance
  void drag(NavigationDrag drag, QPointF movement);  // in pixels

  void set_navigation(NavigationPreset preset) { navigation_ = preset; }
  [[nodiscard]] NavigationPreset navigation() const { return navigation_; }

 Q_SIGNALS:
  void moved();

 private:
  void frame(const Sphere& sphere);

  const Document& document_;
  const Projection projection_;
  const QWidget& pane_;
  Camera camera_;
  NavigationPreset navigation_ = NavigationPreset::brume;
};

}  // namespace brume
