#pragma once

#include <QRubberBand>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "app/viewport/axis_view.h"
#include "app/viewport/frame_quality.h"
#include "app/viewport/handles.h"
#include "app/viewport/navigation.h"
#include "app/viewport/view_input.h"
#include "app/viewport/view_services.h"

namespace brume {

class Document;
class Legend;
class Tool;
class ViewportSurface;

// The lit picture with the handles over it, and the view's own camera: moving it is no edit. One
// pane of the ViewGrid.
class Viewport : public QWidget {
  Q_OBJECT
 public:
  Viewport(Document& document, ViewServices& services, Projection projection, QWidget* parent);
  ~Viewport() override;

  // A view along an axis pans and zooms, but does not turn; it leaves out fog that is everywhere,
  // which would hide all from a camera so far away.
  [[nodiscard]] Projection projection() const { return projection_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  // A camera that no scene file may hold (further out than its limits, say) is not taken.
  void set_camera(const Camera& camera);
  // From which a camera with the usual field of view sees as much as this one [u]: what sizes of
  // new things are taken from.
  [[nodiscard]] double distance() const;
  void go_home();  // to the scene's camera; along an axis: all fog is seen
  void frame_all();
  void frame_selection();       // all, if nothing is selected
  void zoom_by(double factor);  // of the distance

  [[nodiscard]] double exposure() const { return exposure_; }
  void set_exposure(double stops);
  [[nodiscard]] ViewMode mode() const { return mode_; }
  void set_mode(ViewMode mode);

  void set_navigation(NavigationPreset preset) { navigation_ = preset; }
  [[nodiscard]] NavigationPreset navigation() const { return navigation_; }

  // What has the left button from now on; a gesture in flight is cancelled. nullptr: nothing.
  void set_tool(Tool* tool);
  // Works off what the mouse has done so far; else that comes when no more events of it wait.
  void finish_input() { input_.hand_on(); }
  // Soon, as when the tool's cursor has moved.
  void update_overlay() { overlay_timer_.start(0); }

  // The moment that the view shows [s].
  [[nodiscard]] double time() const { return time_; }
  void set_time(double time);
  // All that is there at that moment, particles of emitters included; hidden Gaussians are not.
  [[nodiscard]] std::shared_ptr<const Scene> shown_scene() const;

  // How frames are rendered, and how wrong they are.
  [[nodiscard]] FrameQuality& quality() { return quality_; }
  [[nodiscard]] const FrameQuality& quality() const { return quality_; }

  // Whether it is the view that keys, panels and the error meter are about.
  void set_active(bool active);
  [[nodiscard]] TransferJob& transfer_job() { return *services_.transfer_job; }

  // The view in widget coordinates.
  [[nodiscard]] Film film() const;
  [[nodiscard]] CameraRays rays() const { return {camera_, film()}; }
  [[nodiscard]] const Handles& handles() const { return handles_; }
  void set_hovered(std::optional<GaussianId> id);
  void show_band(const QRect& rectangle);  // null: none
  // What tools turn around and paint through: the middle of the selection, else the camera's
  // target.
  [[nodiscard]] glm::dvec3 pivot() const;
  // Where a ball is seen under the mouse (in the middle of the film if that is elsewhere): on the
  // plane across the view through the camera's target, or before the surface that is before it.
  [[nodiscard]] glm::dvec3 place_under_mouse(double radius);
  // What a shift on the film by some pixels is in the world, at the depth of the pivot.
  [[nodiscard]] glm::dvec3 shift_on_film(QPointF pixels) const;
  // Of the Gaussians that are not locked the one that takes most light from the ray at a position:
  // what a user means who points at fog. nullopt where there is hardly any.
  [[nodiscard]] std::optional<GaussianId> most_visible(QPointF position);
  [[nodiscard]] SurfacePicker& surfaces() { return services_.surfaces; }

  // The frame on screen; nullptr before the first. In motion it may have no layers.
  [[nodiscard]] const RenderedFrame* shown() const { return shown_.get(); }
  // Whether it shows the present state at full resolution.
  [[nodiscard]] bool is_settled() const;
  // Whether its error is known as well, and with it that auto will not choose another.
  [[nodiscard]] bool is_measured() const { return is_settled() && quality_.is_measured(); }

  // The error of the frame on screen as far as it is known; nullptr where it is not shown.
  [[nodiscard]] const ErrorMap* error_map() const { return error_map_.get(); }

  // Why the picture is shown without OpenGL; empty if it is not.
  [[nodiscard]] QString gl_problem() const;
  [[nodiscard]] bool has_gl() const { return gl_problem().isEmpty(); }

 Q_SIGNALS:
  void used();                        // by mouse, wheel or keys
  void pointed_at(QPointF position);  // by the mouse, with no button down
  void frame_shown();
  void mode_changed();
  void failed(const QString& message);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void frame(const Sphere& sphere);
  void request_frame();
  void request_at_rest();
  void measure();
  void map_error();  // where that is to be seen and nothing else is due
  void forget_error_map();
  void take_frame(const std::shared_ptr<const RenderedFrame>& frame);
  [[nodiscard]] bool shows_handles() const;
  void refresh_handles();
  void show_picture();
  void place_legend();
  void draw_overlay();
  [[nodiscard]] FrameRequest frame_request(bool moving) const;

  Document& document_;
  ViewServices& services_;
  const Projection projection_;
  ViewportSurface* surface_;
  ViewInput input_;
  QRubberBand band_;
  Legend* legend_;
  bool active_ = false;
  NavigationPreset navigation_ = NavigationPreset::brume;

  Camera camera_;
  double exposure_ = 0.0;
  ViewMode mode_ = ViewMode::final;
  double time_ = 0.0;
  // shown_scene() where that is not the snapshot itself, and what it is of.
  mutable std::shared_ptr<const Scene> at_time_;
  mutable std::shared_ptr<const Scene> at_time_of_;

  Handles handles_;
  std::optional<GaussianId> hovered_;
  QTimer overlay_timer_;

  std::uint64_t serial_ = 0;         // of the state that frames should show
  std::uint64_t oldest_serial_ = 0;  // frames before this show another scene
  std::shared_ptr<const RenderedFrame> shown_;
  std::shared_ptr<const ErrorMap> error_map_;  // of the frame on screen
  std::shared_ptr<const Scene> rested_scene_;  // of the last frame at rest
  QTimer rest_timer_;
  FrameQuality quality_;
};

}  // namespace brume
