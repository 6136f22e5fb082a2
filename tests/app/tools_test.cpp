// The tools that paint and erase, with a mouse and a keyboard.

#include <QComboBox>
#include <glm/geometric.hpp>
#include <set>

#include "app/tools/brushes/eraser_tool.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/tool_box.h"
#include "app/viewport/viewport.h"
#include "app/widgets/keys.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "core/scene/camera_rays.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

template <class T>
T& tool(ToolBox& tools) {
  return dynamic_cast<T&>(tools.tool());
}

QString active_name(TestWindow& window) {
  return window->tools().entries()[window->tools().active()].name;
}

// The mean brightness of the picture around a place, as it is rendered.
double brightness(TestWindow& window, QPoint at) {
  const QImage& picture = window.shown().picture;
  double sum = 0.0;
  for (int y = at.y() - 4; y <= at.y() + 4; ++y) {
    for (int x = at.x() - 4; x <= at.x() + 4; ++x) sum += qGray(picture.pixel(x, y));
  }
  return sum / 81.0;
}

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void keys_are_unique_and_actions_exist() {
    TestWindow window;
    std::set<QString> keys;
    for (const KeyEntry& entry : key_table()) {
      auto* action = window->findChild<QAction*>(entry.action);
      QVERIFY2(action, entry.action);
      QVERIFY2(!action->shortcuts().isEmpty(), entry.action);
      for (const QKeySequence& key : action->shortcuts()) {
        QVERIFY2(keys.insert(key.toString()).second, qPrintable(key.toString()));
      }
    }
  }

  void a_key_can_be_rebound() {
    QSettings().setValue("keys/tool.paintbrush", "Ctrl+F7");
    TestWindow window;
    window.key(Qt::Key_B);
    QCOMPARE(active_name(window), "select");
    window.key(Qt::Key_F7, Qt::ControlModifier);
    QCOMPARE(active_name(window), "paintbrush");
    QSettings().remove("keys/tool.paintbrush");
  }

  void every_tool_has_a_key_an_icon_and_a_button() {
    TestWindow window;
    const auto& entries = window->tools().entries();
    for (std::size_t k = 0; k < entries.size(); ++k) {
      auto* action = window->findChild<QAction*>("tool." + entries[k].name);
      QVERIFY2(action, qPrintable(entries[k].name));
      QVERIFY(!action->icon().isNull());
      const QImage icon = action->icon().pixmap(24, 24).toImage();
      int drawn = 0;
      for (int y = 0; y < icon.height(); ++y) {
        for (int x = 0; x < icon.width(); ++x) drawn += qAlpha(icon.pixel(x, y)) > 100;
      }
      QVERIFY2(drawn > 30, qPrintable(entries[k].name));
      window->tools().activate(k == 0 ? 1 : 0);
      const QKeyCombination key = action->shortcut()[0];
      window.key(key.key(), key.keyboardModifiers());
      QCOMPARE(window->tools().active(), k);
      QVERIFY(action->isChecked());
      QVERIFY(!entries[k].tool->hint().isEmpty());
    }
  }

  void text_fields_receive_their_keys() {
    TestWindow window;
    window->document().select({1});
    auto* radius = window->findChild<NumberField*>("radius");
    radius->setFocus();
    QTest::keyClicks(radius, "be[");
    QCOMPARE(active_name(window), "select");
    QCOMPARE(radius->text(), "be[");
  }

  void a_stroke_paints_on_the_view_plane_as_one_step() {
    TestWindow window(small_scene(), {900, 775});  // where there is no fog
    Document& document = window->document();
    const Scene before = document.scene();
    const QPoint from(430, 200);
    const double dark = brightness(window, from);
    window.key(Qt::Key_B);
    PaintbrushTool& tool = ::tool<PaintbrushTool>(window->tools());
    tool.set_plane(PaintPlane::view);
    tool.set_brush({.radius = 0.2, .density = 3.0, .spacing = 1.0, .scatter = 0.9});
    window.drag(from, from + QPoint(150, 60));
    QCOMPARE(step_count(document), 1);
    const std::size_t painted = document.medium().size() - 5;
    QVERIFY(painted >= 6);
    QCOMPARE(last_step(document), QString("Paint %1 Gaussians").arg(painted));
    QVERIFY(document.selection().empty());
    // The first is where the mouse went down, on the plane through the target; none leaves the
    // stroke by its radius.
    const CameraRays rays = window->viewport().rays();
    const glm::dvec3 first = document.medium().centers()[5];
    const glm::dvec3 on_film = rays.project(first);
    QVERIFY(std::hypot(on_film.x - from.x(), on_film.y - from.y()) < 1.0);
    QVERIFY(std::abs(on_film.z -
                     glm::dot(document.scene().camera.target - rays.eye(), rays.forward())) < 1e-9);
    const auto at_depth_1 = [&](QPoint at) {
      const glm::dvec3 d = rays.direction(at.x(), at.y());
      return d / glm::dot(d, rays.forward());
    };
    const glm::dvec3 direction =
        glm::normalize(at_depth_1(from + QPoint(150, 60)) - at_depth_1(from));
    for (std::size_t k = 5; k < document.medium().size(); ++k) {
      const glm::dvec3 way = document.medium().centers()[k] - first;
      QVERIFY(glm::length(way - direction * glm::dot(way, direction)) < 0.18 + 1e-3);
      QCOMPARE(document.medium().radii()[k], 0.2);
      QCOMPARE(document.medium().densities()[k], 3.0);
    }
    QVERIFY(window.settle());
    QVERIFY(brightness(window, from) > dark + 10.0);
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
    window.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(document.medium().size(), painted + 5);
    QVERIFY(window.settle());
  }

  void the_picture_follows_while_the_mouse_is_down() {
    TestWindow window;
    window.key(Qt::Key_B);
    window.press(QPoint(300, 200));
    window.move(QPoint(380, 230));
    window.move(QPoint(384, 232));  // a curve is one position behind
    const std::size_t now = window->document().medium().size();
    QVERIFY(now > 6);
    QTRY_COMPARE(window.shown().request.scene->medium.size(), now);
    window.release(QPoint(380, 230));
  }

  void a_running_stroke_can_be_cancelled() {
    Desk desk;
    Document& document = desk.document();
    DeskView& view = desk.view();
    const Scene before = document.scene();
    desk.key(Qt::Key_B);
    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(300, 200));
    desk.move(QPoint(380, 230));
    QTest::keyClick(&view, Qt::Key_Escape);
    desk.move(QPoint(420, 260));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(420, 260));
    QVERIFY(document.scene() == before);
    QCOMPARE(step_count(document), 0);

    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(300, 200));
    desk.move(QPoint(380, 230));
    document.undo_stack().undo();
    desk.move(QPoint(420, 260));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(420, 260));
    QVERIFY(document.scene() == before);
    QVERIFY(document.undo_stack().canRedo());

    // Another tool in the middle of it.
    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(300, 200));
    desk.move(QPoint(380, 230));
    QTest::keyClick(&view, Qt::Key_V);
    QVERIFY(document.scene() == before);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(420, 260));
  }

  void the_ground_and_the_sky() {
    Scene scene = small_scene();
    scene.camera.eye = {0.0, 2.0, 6.0};
    Desk desk(scene);
    desk.key(Qt::Key_B);
    ::tool<PaintbrushTool>(desk.tools()).set_plane(PaintPlane::ground);
    PaintbrushTool& tool = ::tool<PaintbrushTool>(desk.tools());
    tool.set_brush({.radius = 0.2, .density = 1.0, .spacing = 1.0, .scatter = 0.0});
    const int bottom = desk.view().height() - 20;
    desk.drag(QPoint(200, bottom), QPoint(350, bottom));
    const Medium& medium = desk.document().medium();
    QVERIFY(medium.size() > 7);
    for (std::size_t k = 5; k < medium.size(); ++k) {
      QVERIFY(std::abs(medium.centers()[k].y) < 1e-9);
    }
    const std::size_t painted = medium.size();
    desk.drag(QPoint(200, 5), QPoint(350, 5));  // above the horizon there is no ground
    QCOMPARE(medium.size(), painted);
    QCOMPARE(step_count(desk.document()), 1);
  }

  void a_paint_plane_can_be_positioned() {
    Desk desk;
    desk.key(Qt::Key_B);
    PaintbrushTool& tool = ::tool<PaintbrushTool>(desk.tools());
    tool.set_brush({.radius = 0.2, .density = 1.0, .spacing = 1.0, .scatter = 0.0});
    auto* box = desk.findChild<QComboBox*>("brush_plane");
    auto* at = desk.findChild<ValueField*>("brush_position");
    QVERIFY(!at->isVisible());
    const auto paint_at = [&](PaintPlane plane, const char* position) {
      box->setCurrentIndex(static_cast<int>(plane));
      Q_EMIT box->activated(static_cast<int>(plane));
      QVERIFY(at->isVisible());
      auto* field = at->findChild<NumberField*>();
      field->setFocus();
      QTest::keyClicks(field, position);
      QTest::keyClick(field, Qt::Key_Return);
      const int low = desk.view().height() - 20;
      desk.drag(QPoint(300, low), QPoint(400, low - 10));
    };
    const Medium& medium = desk.document().medium();
    const auto check = [&](std::size_t first, int axis, double position) {
      QVERIFY(medium.size() > first);
      for (std::size_t k = first; k < medium.size(); ++k) {
        QVERIFY(std::abs(medium.centers()[k][axis] - position) < 1e-9);
      }
    };
    paint_at(PaintPlane::wall_z, "-1.5");
    check(5, 2, -1.5);
    const std::size_t painted = medium.size();
    paint_at(PaintPlane::ground, "-2.25");
    check(painted, 1, -2.25);
  }

  void brackets_and_alt_set_the_brush() {
    TestWindow window;
    window.key(Qt::Key_B);
    PaintbrushTool& tool = ::tool<PaintbrushTool>(window->tools());
    const Paintbrush before = tool.brush();
    window.key(Qt::Key_BracketRight);
    QVERIFY(tool.brush().radius > before.radius && tool.brush().density == before.density);
    auto* field = window->findChild<ValueField*>("brush_radius")->findChild<NumberField*>();
    QCOMPARE(field->text().toDouble(), QString::number(tool.brush().radius, 'g', 6).toDouble());
    window.key(Qt::Key_BracketLeft);
    QVERIFY(std::abs(tool.brush().radius / before.radius - 1.0) < 1e-12);
    window.key(Qt::Key_BracketRight, Qt::ShiftModifier);
    QVERIFY(tool.brush().density > before.density);
    window.key(Qt::Key_BracketLeft, Qt::ShiftModifier);

    window.click(window.handle(1), Qt::AltModifier);
    QCOMPARE(tool.brush().radius, window->document().medium().radii()[1]);
    QCOMPARE(tool.brush().density, 0.8);
    QVERIFY(!window->document().is_modified());
    window.key(Qt::Key_E);
    window.key(Qt::Key_BracketRight);
    QVERIFY(::tool<EraserTool>(window->tools()).radius() > 40.0);
  }

  void the_eraser_thins_and_deletes_as_one_step() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    desk.key(Qt::Key_E);
    const QPoint at = desk.handle(1);
    desk.click(at);
    QCOMPARE(last_step(document), "Erase 1 Gaussian");
    QVERIFY(document.medium().densities()[1] < 0.8 && document.medium().densities()[1] > 0.3);
    QCOMPARE(document.medium().densities()[0], 0.8);
    desk.drag(at - QPoint(60, 0), at + QPoint(60, 0));
    QCOMPARE(step_count(document), 2);
    QVERIFY(!document.medium().index_of(2));
    QCOMPARE(document.medium().size(), 4u);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
    desk.press(at);
    QVERIFY(document.is_modified());
    QTest::keyClick(&desk.view(), Qt::Key_Escape);
    desk.release(at);
    QVERIFY(document.scene() == before);
    QVERIFY(!document.is_modified());
  }
};

BRUME_APP_SUITE("tools", ToolsTest)
#include "tools_test.moc"
