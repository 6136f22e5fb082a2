// Strokes go where the mouse went, however fast it was and however busy the window.

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/brushes/eraser_tool.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/selection/brush_select_tool.h"
#include "app/tools/tool_box.h"
#include "app/viewport/viewport.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

constexpr double turns = 4.0;
constexpr int positions_per_turn = 16;     // half a second of a mouse at 125 Hz
constexpr double brush = 15.0;             // pixels
constexpr double tolerance = 0.1 * brush;  // half a pixel is lost where the mouse is on whole ones

// From the middle of the view out to 110 pixels.
QPointF spiral(const Viewport& view, double turn) {
  const double angle = 2.0 * std::numbers::pi * turn;
  const double radius = 110.0 * turn / turns;
  return QPointF(view.rect().center()) + radius * QPointF(std::cos(angle), std::sin(angle));
}

double distance_to_spiral(const Viewport& view, QPointF point) {
  double nearest = 1e9;
  for (double turn = 0.0; turn <= turns; turn += 1e-3) {
    nearest = std::min(nearest, QLineF(spiral(view, turn), point).length());
  }
  return nearest;
}

std::vector<QPoint> positions(const Viewport& view) {
  std::vector<QPoint> places;
  for (int k = 0; k <= turns * positions_per_turn; ++k) {
    const QPoint place = spiral(view, static_cast<double>(k) / positions_per_turn).toPoint();
    if (places.empty() || places.back() != place) places.push_back(place);
  }
  return places;
}

// The mouse itself, which does not wait for the window: its moves do.
class Mouse : public QObject {
 public:
  explicit Mouse(Viewport& view) : view_(view) { view.installEventFilter(this); }

  [[nodiscard]] int moves() const { return moves_; }

  // All moves at once, as they come to a window that was busy all the while.
  bool go(std::span<const QPoint> places) {
    const int before = moves_;
    for (const QPoint place : places) QCursor::setPos(view_.mapToGlobal(place));
    const auto are_there = [&] {
      return last_ == places.back() && moves_ - before >= std::ssize(places);
    };
    return QTest::qWaitFor(are_there, patience);
  }

  // A stroke in two such bursts, with a frame in between.
  bool draw(const std::vector<QPoint>& places) {
    // Into the view first: until it knows of the mouse, moves may be merged.
    const QPoint corner(20, 80);  // below the header
    if (!go({&corner, 1}) || !go({&places.front(), 1})) return false;
    QWidget& window = *view_.window();
    const auto in_window = [&](QPoint place) { return view_.mapTo(&window, place); };
    QTest::mousePress(window.windowHandle(), Qt::LeftButton, {}, in_window(places.front()));
    const std::span<const QPoint> rest = std::span(places).subspan(1);
    const std::size_t half = rest.size() / 2;
    const RenderedFrame* shown = view_.frames().shown();
    if (!go(rest.first(half))) return false;
    const auto has_frame = [&] { return view_.frames().shown() != shown; };
    if (frames_ && !QTest::qWaitFor(has_frame, patience)) return false;
    if (!go(rest.subspan(half))) return false;
    QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {}, in_window(places.back()));
    return true;
  }
  // Whether what is drawn makes frames: selecting does not.
  void set_frames(bool frames) { frames_ = frames; }

 protected:
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::MouseMove) {
      ++moves_;
      last_ = static_cast<QMouseEvent*>(event)->position().toPoint();
    }
    return false;
  }

 private:
  Viewport& view_;
  int moves_ = 0;
  QPoint last_;
  bool frames_ = true;
};

// On the plane through the camera's target, where a brush paints too.
glm::dvec3 in_the_world(const Viewport& view, QPointF place) {
  return view.pivot() + view.shift_on_film(place - QRectF(view.rect()).center());
}

// Gaussians at places of the film, in a window that has no others.
void put(TestWindow& window, const std::vector<QPointF>& places) {
  Document& document = window->document();
  Scene scene = document.scene();
  scene.medium = {};
  for (const QPointF place : places) {
    scene.medium.append({in_the_world(window->viewport(), place), 0.05, 0.5});
  }
  document.open(std::move(scene), {});
}

std::vector<QPointF> along_the_spiral(const Viewport& view) {
  std::vector<QPointF> places;
  for (double turn = 0.5; turn < turns; turn += 0.06) places.push_back(spiral(view, turn));
  return places;
}

QPointF on_film(const Viewport& view, const glm::dvec3& point) {
  const glm::dvec3 at = view.rays().project(point);
  return {at.x, at.y};
}

template <class T>
T& choose(TestWindow& window, Qt::Key key) {
  window.key(key);
  return dynamic_cast<T&>(window->tools().tool());
}

}  // namespace

class StrokesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_paintbrush_paints_the_spiral() {
    TestWindow window;
    Viewport& view = window->viewport();
    auto& tool = choose<PaintbrushTool>(window, Qt::Key_B);
    tool.set_brush({.radius = glm::length(view.shift_on_film({brush, 0.0})),
                    .density = 0.5,
                    .spacing = 0.5,
                    .scatter = 0.0});
    Mouse mouse(view);
    QVERIFY(mouse.draw(positions(view)));
    const auto centers = window->document().medium().centers().subspan(5);
    std::vector<QPointF> painted;
    for (const glm::dvec3& center : centers) {
      painted.push_back(on_film(view, center));
      const double distance = distance_to_spiral(view, painted.back());
      QVERIFY2(distance < tolerance, qPrintable(QString::number(distance)));
    }
    for (const QPointF place : along_the_spiral(view)) {
      const auto is_near = [&](QPointF at) { return QLineF(place, at).length() < brush; };
      QVERIFY(std::ranges::any_of(painted, is_near));
    }
    QCOMPARE(step_count(window->document()), 1);
  }

  void the_eraser_thins_the_spiral() {
    TestWindow window;
    Viewport& view = window->viewport();
    put(window, along_the_spiral(view));
    auto& tool = choose<EraserTool>(window, Qt::Key_E);
    while (tool.radius() > 0.5 * brush) tool.change_size(0.9);
    Mouse mouse(view);
    QVERIFY(mouse.draw(positions(view)));
    for (const double density : window->document().medium().densities()) {
      QVERIFY2(density < 0.4, qPrintable(QString::number(density)));
    }
  }

  void the_airbrush_sprays_along_the_spiral() {
    TestWindow window;
    Viewport& view = window->viewport();
    auto& tool = choose<AirbrushTool>(window, Qt::Key_A);
    Airbrush airbrush = tool.airbrush();
    airbrush.rate = 300.0;
    airbrush.speed = airbrush.wander = 0.0;
    tool.set_airbrush(airbrush);
    Mouse mouse(view);
    tool.set_clock([&mouse] { return 8 * mouse.moves(); });
    QVERIFY(mouse.draw(positions(view)));
    const auto centers = window->document().medium().centers().subspan(5);
    QVERIFY(centers.size() > 80);
    std::array<int, 4> on_turn{};
    for (const glm::dvec3& center : centers) {
      const QPointF at = on_film(view, center);
      const double distance = distance_to_spiral(view, at);
      QVERIFY2(distance < tolerance, qPrintable(QString::number(distance)));
      const double radius = QLineF(at, view.rect().center()).length();
      ++on_turn.at(std::min<std::size_t>(3, static_cast<std::size_t>(radius / 27.5)));
    }
    for (const int count : on_turn) QVERIFY(count > 5);
  }

  void brush_selection_takes_the_spiral() {
    TestWindow window;
    Viewport& view = window->viewport();
    put(window, along_the_spiral(view));
    auto& tool = choose<BrushSelectTool>(window, Qt::Key_C);
    for (int k = 0; k < 60; ++k) tool.change_size(0.9);
    tool.change_size(tolerance);  // from 1 pixel
    Mouse mouse(view);
    mouse.set_frames(false);
    QVERIFY(mouse.draw(positions(view)));
    QCOMPARE(window->document().selection().size(), window->document().medium().size());
  }

  // Few positions on a circle: what is inside it but outside their polygon is selected.
  void the_lasso_is_round() {
    TestWindow window;
    Viewport& view = window->viewport();
    const auto place = [&](double part, double radius) {
      const double angle = 2.0 * std::numbers::pi * part;
      return QPointF(view.rect().center()) + radius * QPointF(std::cos(angle), std::sin(angle));
    };
    constexpr int corners = 12;
    std::vector<QPointF> handles;
    // But for the ends, where nothing says how the line bends.
    constexpr int between = corners - 2;
    for (const double radius : {118.0, 122.0}) {
      for (int k = 1; k <= between; ++k) handles.push_back(place((k + 0.5) / corners, radius));
    }
    put(window, handles);
    std::vector<QPoint> line;
    for (int k = 0; k <= corners; ++k) {
      line.push_back(place(static_cast<double>(k) / corners, 120.0).toPoint());
    }
    window.key(Qt::Key_L);
    Mouse mouse(view);
    mouse.set_frames(false);
    QVERIFY(mouse.draw(line));
    const auto ids = window->document().medium().ids();
    const std::vector<GaussianId> inner(ids.begin(), ids.begin() + between);
    QCOMPARE(window->document().selection(), inner);
  }

  // Handlers that need only the newest position are not called for each.
  void elsewhere_moves_are_merged() {
    TestWindow window;
    Viewport& view = window->viewport();
    const auto are_merged = [] {
      return QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents);
    };
    QCursor::setPos(view.mapToGlobal(QPoint(30, 30)));
    QTRY_VERIFY(!are_merged());
    QCursor::setPos(window->mapToGlobal(QPoint(window->width() - 30, 200)));
    QTRY_VERIFY(are_merged());
  }
};

BRUME_APP_SUITE("strokes", StrokesTest)
#include "strokes_test.moc"
