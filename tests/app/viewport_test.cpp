// The viewport with a mouse and a keyboard.

#include <QLabel>
#include <QWheelEvent>
#include <glm/geometric.hpp>

#include "app/files/scene_files.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/viewport/viewport.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

class ViewportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_click_selects_the_row_too() {
    TestWindow window;
    Viewport& view = window->viewport();
    QTest::mouseClick(&view, Qt::LeftButton, {}, window.handle(2));
    QCOMPARE(window->document().selection(), std::vector<GaussianId>{3});
    auto* table = window->findChild<GaussianPanel*>()->table();
    QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
    QCOMPARE(table->selectionModel()->selectedRows().first().row(), 2);

    QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, window.handle(4));
    QCOMPARE(window->document().selection(), (std::vector<GaussianId>{3, 5}));
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, window.handle(2));
    QCOMPARE(window->document().selection(), std::vector<GaussianId>{5});
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(5, 5));
    QVERIFY(window->document().selection().empty());
    QVERIFY(!window->document().is_modified());
  }

  void a_row_selects_the_handle_too() {
    Desk desk;
    desk.findChild<GaussianPanel*>()->table()->selectRow(1);
    QCOMPARE(desk.document().selection(), std::vector<GaussianId>{2});
  }

  void a_rectangle_selects_enclosed_centers() {
    Desk desk;
    const QPoint around(20, 20);
    const QRect both = QRect(desk.handle(0), desk.handle(3)).normalized();
    desk.drag(both.topLeft() - around, both.bottomRight() + around);
    QCOMPARE(desk.document().selection(), (std::vector<GaussianId>{1, 4}));
  }

  void a_drag_moves_the_selection_as_one_step() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    document.select({2, 3});
    const QPoint from = desk.handle(1);
    const QPoint to = from + QPoint(40, 25);
    desk.drag(from, to);
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Move 2 Gaussians");
    // The handle went with the mouse, in the plane of the film; the other one went along.
    QVERIFY((desk.handle(1) - to).manhattanLength() <= 2);
    const auto moved = [&](std::size_t k) {
      return document.medium().centers()[k] - before.medium.centers()[k];
    };
    QVERIFY(std::abs(moved(1).z) < 1e-12);
    QVERIFY(glm::length(moved(1)) > 0.1);
    QVERIFY(glm::distance(moved(1), moved(2)) < 1e-12);
    QVERIFY(moved(0) == glm::dvec3(0.0));
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
  }

  void dragging_an_unselected_handle_moves_nothing() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    document.select({3});
    const QPoint aside(2, 2);  // so that the handle is inside, whatever it is rounded to
    const QPoint from = desk.handle(1) - aside;
    QVERIFY(desk.view().handles().pick(from));
    desk.drag(from, from + QPoint(40, 25));
    QVERIFY(document.scene() == before);
    // It is a rectangle, as from anywhere else.
    QCOMPARE(document.selection(), std::vector<GaussianId>{2});
    desk.drag(desk.handle(1), desk.handle(1) + QPoint(40, 25));
    QCOMPARE(last_step(document), "Move 1 Gaussian");
    // With Shift it adds what is inside.
    desk.drag(desk.handle(0) - aside, desk.handle(3) + 3 * aside, Qt::LeftButton,
              Qt::ShiftModifier);
    QCOMPARE(document.selection(), (std::vector<GaussianId>{1, 2, 4}));
  }

  void a_drag_ends_with_its_scene() {
    Desk desk;
    Document& document = desk.document();
    DeskView& view = desk.view();
    const QPoint from = desk.handle(1);
    for (const int steps_before : {0, 1}) {
      document.select({2});
      QTest::mousePress(&view, Qt::LeftButton, {}, from);
      for (int k = 0; k < steps_before; ++k) desk.move(from + QPoint(30, 0));
      document.open(load_scene(document.file()), document.file());  // as when one was read
      const Scene fresh = document.scene();
      desk.move(from + QPoint(40, 0));
      desk.move(from + QPoint(60, 10));
      QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(60, 10));
      QVERIFY(document.scene() == fresh);
      QCOMPARE(step_count(document), 0);
      QVERIFY(document.selection().empty());
      QTest::mousePress(&view, Qt::LeftButton, {}, from);
      desk.move(from + QPoint(30, 0));
      QTest::keyClick(&view, Qt::Key_Escape);
      QTest::mouseRelease(&view, Qt::LeftButton, {}, from);
    }
  }

  void a_drag_ends_with_its_gaussians() {
    TestWindow window;
    Document& document = window->document();
    Viewport& view = window->viewport();
    window.key(Qt::Key_A, Qt::ShiftModifier);
    const QPoint from = window.handle(5);
    const glm::dvec3 start = document.medium().centers()[5];
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    window.move(from + QPoint(30, 0));
    document.undo_stack().setIndex(0);
    document.undo_stack().setIndex(1);  // there again, but let go
    window.move(from + QPoint(60, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(60, 0));
    QVERIFY(document.medium().centers()[5] == start);
    QCOMPARE(document.undo_stack().index(), 1);
  }

  void the_camera_stays_within_file_limits() {
    TestWindow window;
    Viewport& view = window->viewport();
    for (const int delta : {-12000, 12000}) {
      for (int k = 0; k < 20; ++k) {
        turn_wheel(view, {9, 9}, delta);
      }
      window.key(Qt::Key_0, Qt::ControlModifier);
      QVERIFY(window->files().save());
      QVERIFY(window.open("scene.brume"));
    }
  }

  void navigation_is_no_edit() {
    TestWindow window;
    Viewport& view = window->viewport();
    const Camera start = view.camera();
    const QPoint middle = view.rect().center();
    window.drag(middle, middle + QPoint(60, 20), Qt::MiddleButton);
    QVERIFY(glm::distance(view.camera().eye, start.eye) > 0.1);
    QVERIFY(std::abs(target_distance(view.camera()) - target_distance(start)) < 1e-9);
    const Camera orbited = view.camera();
    window.drag(middle, middle + QPoint(30, 0), Qt::MiddleButton, Qt::ShiftModifier);
    QVERIFY(view.camera().target != orbited.target);
    const double distance = glm::distance(view.camera().eye, view.camera().target);
    turn_wheel(view, middle, 120);
    QVERIFY(glm::distance(view.camera().eye, view.camera().target) < distance);
    window.drag(middle, middle + QPoint(10, 10), Qt::LeftButton, Qt::AltModifier);
    QVERIFY(window->document().selection().empty());
    window.key(Qt::Key_Home);
    for (std::size_t k = 0; k < 5; ++k) QVERIFY(view.rect().contains(window.handle(k)));
    window->document().select({3});
    window.key(Qt::Key_F);
    QVERIFY((window.handle(2) - middle).manhattanLength() <= 2);
    QVERIFY(!window->document().is_modified());
    QVERIFY(window.settle());
  }

  void tab_shows_the_airlight_and_the_optical_depth() {
    TestWindow window;
    Viewport& view = window->viewport();
    const QPoint at = window.handle(1);
    const QPoint corner(5, 5);  // no fog there
    const Frame& frame = view.frames().shown()->frame;
    const auto pixel = [&](QPoint p) {
      return static_cast<std::size_t>(p.y()) * static_cast<std::size_t>(frame.film.width) +
             static_cast<std::size_t>(p.x());
    };
    window.key(Qt::Key_Tab);
    QVERIFY(view.frames().mode() == ViewMode::airlight);
    // Without surfaces the picture is airlight and nothing else.
    QVERIFY(to_picture(frame, {0.0}, ViewMode::airlight) ==
            to_picture(frame, {0.0}, ViewMode::final));
    window.key(Qt::Key_Tab);
    QVERIFY(view.frames().mode() == ViewMode::optical_depth);
    const QImage depths = to_picture(frame, {0.0}, ViewMode::optical_depth);
    QCOMPARE(depths.pixel(corner), depth_color(0.0));
    QCOMPARE(depths.pixel(at), depth_color(-std::log(frame.transmittance[3 * pixel(at) + 1])));
    QVERIFY(depths.pixel(at) != depth_color(0.0));
    // New frames are shown so too.
    window->document().select({2});
    window.key(Qt::Key_Delete);
    QVERIFY(window.settle());
    QVERIFY(view.frames().shown()->request.mode == ViewMode::optical_depth);
    QCOMPARE(view.frames().shown()->picture.pixel(at), depth_color(0.0));
    while (view.frames().mode() != view_modes.back()) window.key(Qt::Key_Tab);
    window.key(Qt::Key_Tab);
    QVERIFY(view.frames().mode() == ViewMode::final);
    QVERIFY(view.hasFocus());
  }

  void it_works_without_opengl() {
    TestWindow window;
    Viewport& view = window->viewport();
    if (qEnvironmentVariableIsSet("BRUME_TEST_NO_OPENGL")) QVERIFY(!view.gl_problem().isEmpty());
    // Picture and handles are there, whatever draws them.
    window->document().select({1});
    const QRect area(view.mapTo(&*window, QPoint(0, 0)), view.size());
    const auto count = [&](auto&& is_wanted) {
      const QImage image = window->grab().toImage();
      int found = 0;
      for (int y = area.top(); y <= area.bottom(); ++y) {
        for (int x = area.left(); x <= area.right(); ++x)
          found += is_wanted(image.pixelColor(x, y));
      }
      return found;
    };
    const auto is_bright = [](const QColor& color) { return color.lightness() > 20; };
    const auto is_accent = [](const QColor& color) {
      return color.red() > 180 && color.green() > 90 && color.blue() < 110;
    };
    QTRY_VERIFY(count(is_bright) > area.width() * area.height() / 20);
    QTRY_VERIFY(count(is_accent) > 60);
  }
};

BRUME_APP_SUITE("viewport", ViewportTest)
#include "viewport_test.moc"
