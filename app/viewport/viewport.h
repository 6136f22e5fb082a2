#pragma once

#include <QRubberBand>
#include <QTimer>
#include <QWidget>

#include "app/frames/frame_scheduler.h"
#include "app/view/view.h"
#include "app/view/view_input.h"
#include "render/geometry/fog_ball.h"

namespace brume {

class CameraFrame;
class Legend;
class Tool;
class ViewportSurface;
struct ViewServices;

// A pane of ViewGrid: shows the frames of a view with what is drawn over them, and passes input on.
class Viewport : public QWidget, public View {
  Q_OBJECT
 public:
  Viewport(Document& document, ViewServices& services, Projection projection, QWidget* parent);
  ~Viewport() override;

  [[nodiscard]] FrameScheduler& frames() { return frames_; }
  [[nodiscard]] const FrameScheduler& frames() const { return frames_; }

  // Sets the left-button tool, cancelling a running gesture. nullptr: none.
  void set_tool(Tool* tool);
  // Processes pending mouse input immediately.
  void finish_input() { input_.flush_moves(); }
  void show_overlay(bool shown);  // what is drawn over the picture
  void set_time(double time) override;
  void show_band(const QRect& rectangle) override;
  // The grid on the ground; initially off.
  void show_ground_grid(bool shown);

  // The frame of the scene's camera, and what of it is to be rendered.
  [[nodiscard]] CameraFrame& camera_frame() { return *camera_frame_; }

  // The name of the scene's camera if it looks through that; or else "Free View".
  [[nodiscard]] QString camera_title() const;

  // Why there is no OpenGL; empty if there is.
  [[nodiscard]] QString gl_problem() const;

 Q_SIGNALS:
  void used();                        // by mouse, wheel or keys
  void pointed_at(QPointF position);  // by the mouse, with no button down
  void menu_asked(QPointF position);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void show_picture();
  void place_legend();
  void show_camera_frame();
  void update_overlay() { overlay_timer_.start(0); }
  void draw_overlay();
  // Where homogeneous fog is that has an extent; endless without.
  const FogBall& fog_ball();

  const Document& document_;
  ViewportSurface* surface_;
  FrameScheduler frames_;
  ViewInput input_;
  QRubberBand band_;
  std::shared_ptr<const Scene> fog_ball_of_;
  FogBall fog_ball_;
  CameraFrame* camera_frame_;
  Legend* legend_;
  QTimer overlay_timer_;
  bool shows_overlay_ = true;
  bool ground_grid_ = false;
};

}  // namespace brume
