#include "tests/app/editor_film.h"

#include <QDockWidget>
#include <QPainter>
#include <QPainterPath>
#include <QSignalSpy>
#include <QToolButton>

#include "app/viewport/viewport.h"
#include "tests/app/driven_window.h"

namespace brume {
namespace {

constexpr QSize film_size(1120, 640);
constexpr int panel_width = 380;
constexpr int patience_per_step = 8000;  // milliseconds until a picture follows the mouse
constexpr int rest_per_frame = 500;      // milliseconds
constexpr int max_resting_frames = 14;

// The arrow of the mouse, with its point in the origin.
QPainterPath mouse_arrow() {
  QPainterPath arrow;
  arrow.addPolygon(
      QPolygonF({{0, 0}, {0, 16}, {4, 12.5}, {7, 19}, {9.5, 18}, {6.5, 11.5}, {12, 11}}));
  arrow.closeSubpath();
  return arrow;
}

class EditorFilm : public DrivenWindow {
 public:
  EditorFilm(const QString& scene, const QString& folder) : DrivenWindow(scene, film_size, folder) {
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
      dock->setVisible(dock->objectName() == "performance");
    }
    auto* performance = window_.findChild<QDockWidget*>("performance");
    window_.resizeDocks({performance}, {panel_width}, Qt::Horizontal);
    window_.findChild<QToolButton*>("performance_details")->click();
    settle();
  }

  void make() {
    mouse_ = QPoint(view().width() / 8, view().height() * 7 / 10);
    hover(mouse_);
    for (int k = 0; k < 5; ++k) take();
    paint_fog();
    rest();
    drag_light();
    rest();
  }

 private:
  // The window with the mouse in it.
  void take() {
    QPixmap picture = window_.grab();
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(view().mapTo(&window_, mouse_));
    painter.setPen(QPen(Qt::black, 1.2));
    painter.setBrush(Qt::white);
    painter.drawPath(mouse_arrow());
    painter.end();
    save(picture, QString("%1").arg(frame_++, 4, 10, QChar('0')));
  }

  // One step of a drag, and the picture that follows it.
  void step(QPoint place) {
    mouse_ = place;
    QSignalSpy shown(&view().frames(), &FrameScheduler::frame_shown);
    move(place);
    shown.wait(patience_per_step);
    take();
  }

  // The mouse rests until the error of the picture is known.
  void rest() {
    for (int k = 0; k < max_resting_frames; ++k) {
      if (k > 4 && view().frames().is_measured()) break;
      QTest::qWait(rest_per_frame);
      take();
    }
    settle();
    for (int k = 0; k < 6; ++k) take();
  }

  void paint_fog() {
    act("tool.paintbrush");
    const QSizeF size = view().size();
    const auto on_stroke = [&](double t) {
      return QPointF((0.1 + 0.5 * t) * size.width(),
                     (0.72 + 0.05 * std::sin(7.0 * t)) * size.height())
          .toPoint();
    };
    press(on_stroke(0.0));
    constexpr int steps = 16;
    for (int k = 0; k <= steps; ++k) step(on_stroke(double(k) / steps));
    release(mouse_);
  }

  // The light nearest to the middle of the view, along an arc.
  void drag_light() {
    act("tool.select");
    window_.document().select({});
    const QPoint middle = view().rect().center();
    QPoint start;
    for (const Light& light : window_.document().scene().lights) {
      const QPoint place = film_position(view(), light.position);
      const auto distance = [&](QPoint point) { return (point - middle).manhattanLength(); };
      if (start.isNull() || distance(place) < distance(start)) start = place;
    }
    for (int k = 0; k <= 6; ++k) {
      mouse_ += (start - mouse_) * k / 6;
      hover(mouse_);
      take();
    }
    press(start);
    constexpr int steps = 16;
    for (int k = 1; k <= steps; ++k) {
      const double t = double(k) / steps;
      step(
          start +
          QPointF(-0.3 * t * view().width(), 0.12 * std::sin(3.1 * t) * view().height()).toPoint());
    }
    release(mouse_);
  }

  QPoint mouse_;
  int frame_ = 0;
};

}  // namespace

bool make_editor_film(const QString& scene, const QString& folder) {
  EditorFilm film(scene, folder);
  film.make();
  return !film.failed();
}

}  // namespace brume
