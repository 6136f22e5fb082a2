// Four views: perspective, and along the axes.

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/files/scene_files.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/viewport/view_grid.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/cameras.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

bool settle_all(const ViewGrid& views) {
  return QTest::qWaitFor(
      [&] {
        return std::ranges::all_of(
            views.panes(), [](const Viewport* pane) { return pane->frames().is_settled(); });
      },
      patience);
}

Viewport& pane(const ViewGrid& views, Projection projection) {
  return *views.panes()[static_cast<std::size_t>(projection)];
}

}  // namespace

class ViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_key_toggles_four_views() {
    TestWindow window;
    ViewGrid& views = window->views();
    QCOMPARE(views.panes().size(), 1u);
    window.key(Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(views.shows_four());
    QCOMPARE(views.panes().size(), 4u);
    QVERIFY(settle_all(views));
    for (const Viewport* one : views.panes()) {
      QVERIFY(one->isVisible());
      // Something is seen: all of the scene is framed.
      const auto& t = one->frames().shown()->frame.transmittance;
      QVERIFY(*std::min_element(t.begin(), t.end()) < 0.7F);
    }
    // The one used last is alone when it is one view again, and has the keys and the figures.
    Viewport& top = pane(views, Projection::top);
    QTest::mouseClick(&top, Qt::LeftButton, {}, QPoint(3, top.height() - 3));
    QCOMPARE(&views.active(), &top);
    invoke(window, "view.four");
    QVERIFY(!views.shows_four());
    QVERIFY(top.isVisible() && !views.perspective().isVisible());
    QVERIFY(QTest::qWaitFor([&] { return top.frames().is_measured(); }, patience));
    QVERIFY(!views.perspective().frames().is_measured());
    invoke(window, "view.four");
    QVERIFY(views.perspective().isVisible());
    QVERIFY(settle_all(views));
  }

  void views_along_the_axes_are_nearly_orthographic() {
    TestWindow window;
    ViewGrid& views = window->views();
    views.show_four(true);
    const auto check = [&](Projection projection, const glm::dvec3& right, const glm::dvec3& up) {
      const Viewport& view = pane(views, projection);
      const double half = half_height(view.camera());
      for (const glm::dvec3& center : window->document().medium().centers()) {
        const glm::dvec3 at = view.rays().project(center);
        const glm::dvec3 from = center - view.camera().target;
        const double per_unit = 0.5 * view.height() / half;
        const QPointF parallel(0.5 * view.width() + per_unit * glm::dot(from, right),
                               0.5 * view.height() - per_unit * glm::dot(from, up));
        // Parallel to within a degree: off by what a depth of the scene's size makes of that.
        QVERIFY((QPointF(at.x, at.y) - parallel).manhattanLength() < 0.02 * view.height());
      }
    };
    check(Projection::top, {1, 0, 0}, {0, 0, -1});
    check(Projection::front, {1, 0, 0}, {0, 1, 0});
    check(Projection::side, {0, 0, -1}, {0, 1, 0});
  }

  void zooming_in_keeps_the_whole_depth() {
    const Sphere scene{{1.0, 2.0, 3.0}, 10.0};
    for (const Projection projection : {Projection::top, Projection::front, Projection::side}) {
      const Camera camera = axis_camera(projection, {4.0, 0.0, 2.0}, 1e-3, scene);
      const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
      QVERIFY(glm::dot(scene.center - camera.eye, forward) > scene.radius);
      QVERIFY(std::abs(half_height(camera) - 1e-3) < 1e-12);
    }
  }

  void navigation_along_an_axis_does_not_turn() {
    TestWindow window;
    ViewGrid& views = window->views();
    views.show_four(true);
    Viewport& front = pane(views, Projection::front);
    const Camera before = front.camera();
    drag_mouse(front, {50, 50}, {80, 70}, Qt::MiddleButton);
    const glm::dvec3 way = front.camera().target - before.target;
    QVERIFY(glm::length(way) > 0.0);
    QVERIFY(std::abs(way.z) < 1e-9);
    QVERIFY(glm::distance(front.camera().eye - before.eye, way) < 1e-9);
    QCOMPARE(&views.active(), &front);
    const double half = half_height(front.camera());
    turn_wheel(front, {9, 9}, 120);
    QVERIFY(half_height(front.camera()) < half);
    front.setFocus();
    QTest::keyClick(&front, Qt::Key_Home);
    QVERIFY(glm::distance(front.camera().target, before.target) < 1e-9);
  }

  void tools_work_in_every_pane() {
    TestWindow window;
    ViewGrid& views = window->views();
    Document& document = window->document();
    views.show_four(true);
    QVERIFY(settle_all(views));
    // A drag on a handle moves in the plane of the pane: in the top view, not up.
    const std::array planes{std::pair{Projection::top, 1}, std::pair{Projection::front, 2},
                            std::pair{Projection::side, 0}};
    for (const auto& [projection, fixed] : planes) {
      Viewport& view = pane(views, projection);
      const glm::dvec3 start = document.medium().centers()[2];
      const QPoint from = film_position(view, start);
      QTest::mouseClick(&view, Qt::LeftButton, {}, from);
      QCOMPARE(document.selection(), std::vector<GaussianId>{3});
      drag_mouse(view, from, from + QPoint(20, -15));
      QCOMPARE(last_step(document), "Move 1 Gaussian");
      const glm::dvec3 way = document.medium().centers()[2] - start;
      QVERIFY(glm::length(way) > 0.05);
      QVERIFY(std::abs(way[fixed]) < 0.02 * glm::length(way));
      QVERIFY((film_position(view, document.medium().centers()[2]) - from - QPoint(20, -15))
                  .manhattanLength() <= 2);
      document.undo_stack().undo();
    }
    // A brush paints on the view plane at the depth of what is selected.
    invoke(window, "tool.paintbrush");
    dynamic_cast<PaintbrushTool&>(window->tools().tool()).set_plane(PaintPlane::view);
    Viewport& top = pane(views, Projection::top);
    const std::size_t count = document.medium().size();
    drag_mouse(top, top.rect().center() - QPoint(40, 0), top.rect().center() + QPoint(40, 0));
    QVERIFY(document.medium().size() > count);
    QVERIFY(last_step(document).startsWith("Paint"));
    for (std::size_t k = count; k < document.medium().size(); ++k) {
      // But for the scatter across the stroke, which is less than the radius.
      const Gaussian painted = document.medium().gaussian(k);
      QVERIFY(std::abs(painted.center.y - document.medium().centers()[2].y) < painted.radius);
    }
    invoke(window, "tool.lasso");
    Viewport& side = pane(views, Projection::side);
    drag_mouse(side, side.rect().center(), side.rect().center() + QPoint(30, 0));
    QVERIFY(settle_all(views));
  }

  void each_pane_has_its_own_mode() {
    TestWindow window;
    ViewGrid& views = window->views();
    views.show_four(true);
    Viewport& side = pane(views, Projection::side);
    side.setFocus();
    QTest::keyClick(&side, Qt::Key_Tab);
    QVERIFY(side.frames().mode() == ViewMode::airlight);
    QVERIFY(views.perspective().frames().mode() == ViewMode::final);
  }

  void homogeneous_fog_does_not_hide_axis_views() {
    Scene scene = small_scene();
    scene.medium.set_homogeneous_density(0.1);
    TestWindow window(scene);
    ViewGrid& views = window->views();
    views.show_four(true);
    QVERIFY(settle_all(views));
    const auto corner = [](const Viewport& view) {
      return view.frames().shown()->frame.transmittance.front();
    };
    QVERIFY(corner(views.perspective()) < 0.6F);
    QVERIFY(corner(pane(views, Projection::top)) > 0.9F);
  }

  void the_active_view_renders_first() {
    FrameService service(std::make_shared<TransferStore>());
    std::vector<int> came;
    connect(&service, &FrameService::frame_ready, this,
            [&](const std::shared_ptr<const RenderedFrame>& frame) {
              came.push_back(frame->request.view);
            });
    FrameRequest request;
    request.scene = std::make_shared<const Scene>(small_scene());
    request.camera = request.scene->camera;
    request.serial = 1;
    request.film = {350, 250};  // long enough to be interrupted
    request.settings.airlight = AirlightMethod::reference;
    for (const int view : {1, 2, 3}) {
      request.view = view;
      service.request(request);
    }
    QTest::qWait(30);
    request.view = 0;
    request.film = {60, 40};
    service.request(request);
    QTRY_VERIFY(came.size() == 4);
    QCOMPARE(came, (std::vector<int>{0, 1, 2, 3}));
  }

  void headers_say_and_change_what_a_view_shows() {
    TestWindow window(small_scene(), {1280, 800});
    Viewport& view = window->viewport();
    auto& header = *view.findChild<ViewHeader*>("view_header");
    QVERIFY(header.isVisible() && view.rect().contains(header.geometry()));
    const auto text = [&](const char* name) {
      return header.findChild<QToolButton*>(name)->text();
    };
    QCOMPARE(text("pane_title"), "Perspective · Final Picture");
    QCOMPARE(text("header_quality"), "Auto");
    QCOMPARE(text("header_camera"), "Camera");
    const Film film = window.shown().request.film;
    QCOMPARE(label_text(*window, "header_resolution"),
             QString("%1 × %2").arg(film.width).arg(film.height));
    view.camera_controller().zoom_by(0.9);
    QCOMPARE(text("header_camera"), "Free View");
    window->findChild<QAction*>("airlight_fast")->trigger();
    QCOMPARE(text("header_quality"), "Fast");
    window->findChild<QAction*>("airlight_auto")->trigger();
    view.frames().set_mode(ViewMode::airlight);
    QCOMPARE(text("pane_title"), "Perspective · Airlight Only");
    // Exposure is typed and reset.
    enter(*window, "header_exposure", "1.5");
    QCOMPARE(view.frames().exposure(), 1.5);
    QTest::mouseClick(header.findChild<QToolButton*>("header_reset"), Qt::LeftButton);
    QCOMPARE(view.frames().exposure(), 0.0);
    for (const char* name :
         {"header_quality", "header_color", "header_camera", "header_overlays"}) {
      const auto* button = header.findChild<QToolButton*>(name);
      QVERIFY2(button->menu() && !button->menu()->actions().isEmpty(), name);
    }
    // In a narrow view what has no room is behind a button.
    window.key(Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier);
    QCoreApplication::processEvents();
    for (const Viewport* pane : window->views().panes()) {
      const auto* narrow = pane->findChild<ViewHeader*>("view_header");
      QVERIFY(pane->rect().contains(narrow->geometry()));
    }
  }

  void titles_of_views_are_legible_in_both_themes() {
    TestWindow window;
    window.key(Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier);
    for (const char* theme : {"theme_light", "theme_dark"}) {
      window->findChild<QAction*>(theme)->trigger();
      for (const Viewport* pane : window->views().panes()) {
        const QPalette palette = pane->findChild<QToolButton*>("pane_title")->palette();
        const int text = palette.color(QPalette::ButtonText).lightness();
        QVERIFY2(std::abs(text - palette.color(QPalette::Window).lightness()) > 60, theme);
      }
    }
  }

  void exposure_stays_with_its_scene() {
    TestWindow window;
    save_document(small_scene(), window.file("other.brume"));
    window->viewport().frames().set_exposure(2.0);
    QVERIFY(window.open("other.brume"));
    QCOMPARE(window->viewport().frames().exposure(), 0.0);
    QVERIFY(window.open("scene.brume"));
    QCOMPARE(window->viewport().frames().exposure(), 2.0);
    window->files().create();
    QCOMPARE(window->viewport().frames().exposure(), 0.0);
  }

  void the_menu_of_the_view_fits_on_a_low_screen() {
    TestWindow window;
    for (const QAction* action : window->menuBar()->actions()) {
      QVERIFY2(action->menu()->sizeHint().height() < 640, qPrintable(action->text()));
    }
  }
};

BRUME_APP_SUITE("views", ViewsTest)
#include "views_test.moc"
