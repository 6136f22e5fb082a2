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

// A pane of ViewGrid: the rendered picture with handles, and its own camera, whose moves are not
// undoable.
class Viewport : public QWidget {
  Q_OBJECT
 public:
  Viewport(Document& document, ViewServices& services, Projection projection, QWidget* parent);
  ~Viewport() override;

  // Axis views pan and zoom but do not orbit; they hide homogeneous fog, which would be opaque from
  // so far away.
  [[nodiscard]] Projection projection() const { return projection_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  // Ignores cameras outside the limits of scene files.
  void set_camera(const Camera& camera);
  // Equivalent distance of a camera with the default field of view [u]; scales the sizes of new
  // objects.
  [[nodiscard]] double distance() const;
  void reset_camera();  // the scene's camera; axis views: frames all Gaussians
  void frame_all();
  void frame_selection();       // all if nothing is selected
  void zoom_by(double factor);  // scales the distance

  [[nodiscard]] double exposure() const { return exposure_; }
  void set_exposure(double stops);
  [[nodiscard]] ViewMode mode() const { return mode_; }
  void set_mode(ViewMode mode);

  void set_navigation(NavigationPreset preset) { navigation_ = preset; }
  [[nodiscard]] NavigationPreset navigation() const { return navigation_; }

  // Sets the left-button tool, cancelling a running gesture. nullptr: none.
  void set_tool(Tool* tool);
  // Processes pending mouse input immediately.
  void finish_input() { input_.flush_moves(); }
  // Schedules an overlay update.
  void update_overlay() { overlay_timer_.start(0); }

  // Displayed time [s].
  [[nodiscard]] double time() const { return time_; }
  void set_time(double time);
  // The scene at that time, including particles, without hidden Gaussians.
  [[nodiscard]] std::shared_ptr<const Scene> shown_scene() const;

  // Render settings and error.
  [[nodiscard]] FrameQuality& quality() { return quality_; }
  [[nodiscard]] const FrameQuality& quality() const { return quality_; }

  // Whether it is the view that keys, panels and the error meter are about.
  void set_active(bool active);
  [[nodiscard]] TransferJob& transfer_job() { return services_.transfer_job; }

  // The film in widget coordinates.
  [[nodiscard]] Film film() const;
  [[nodiscard]] CameraRays rays() const { return {camera_, film()}; }
  [[nodiscard]] const Handles& handles() const { return handles_; }
  void set_hovered(std::optional<GaussianId> id);
  void show_band(const QRect& rectangle);  // null: none
  // Pivot of tools: the selection's center, or the camera's target.
  [[nodiscard]] glm::dvec3 pivot() const;
  // Placement of a sphere under the mouse (or the film's center): on the view plane through the
  // target, or in front of a nearer surface.
  [[nodiscard]] glm::dvec3 place_under_mouse(double radius);
  // World-space vector of a pixel offset at the pivot's depth.
  [[nodiscard]] glm::dvec3 shift_on_film(QPointF pixels) const;
  // The unlocked Gaussian that absorbs most light at a position; nullopt if negligible.
  [[nodiscard]] std::optional<GaussianId> max_visible(QPointF position);
  [[nodiscard]] SurfacePicker& surfaces() { return services_.surfaces; }

  // The displayed frame; nullptr initially. May have no layers in motion.
  [[nodiscard]] const RenderedFrame* shown() const { return shown_.get(); }
  // Whether it is up to date at full resolution.
  [[nodiscard]] bool is_settled() const;
  // Whether its error is known too, so auto has settled.
  [[nodiscard]] bool is_measured() const { return is_settled() && quality_.is_measured(); }

  // Error map of the displayed frame; may be incomplete; nullptr if not shown.
  [[nodiscard]] const ErrorMap* error_map() const { return error_map_.get(); }

  // Why there is no OpenGL; empty if there is.
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
  void map_error();  // if visible and idle
  void forget_error_map();
  void use_frame(const std::shared_ptr<const RenderedFrame>& frame);
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
  // Cache of shown_scene() and the snapshot it derives from.
  mutable std::shared_ptr<const Scene> at_time_;
  mutable std::shared_ptr<const Scene> at_time_of_;

  Handles handles_;
  std::optional<GaussianId> hovered_;
  QTimer overlay_timer_;

  std::uint64_t serial_ = 0;         // of the current state
  std::uint64_t oldest_serial_ = 0;  // older frames belong to another scene
  std::shared_ptr<const RenderedFrame> shown_;
  std::shared_ptr<const ErrorMap> error_map_;  // of the displayed frame
  std::shared_ptr<const Scene> rested_scene_;  // of the last frame at rest
  QTimer rest_timer_;
  FrameQuality quality_;
};

}  // namespace brume
