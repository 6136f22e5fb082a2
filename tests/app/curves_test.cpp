// Curves of animated values: their keys are moved in time and value with the mouse.

#include <QComboBox>
#include <QDockWidget>
#include <QToolButton>

#include "app/document/timeline.h"
#include "app/panels/curve_editor.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

Scene animated_scene() {
  Scene scene = small_scene();
  Light& light = scene.lights.at(0);
  light.keys.intensity = {{.time = 1.0, .value = glm::dvec3(10.0, 20.0, 40.0)},
                          {.time = 3.0, .value = glm::dvec3(30.0, 25.0, 60.0)}};
  light.keys.position = {{.time = 0.0, .value = glm::dvec3(1.0, 2.0, 3.0)}};
  return scene;
}

// The window with the curves of the light's intensity.
class Curves {
 public:
  Curves() : window(animated_scene()) {
    QTest::mouseClick(window->findChild<QToolButton*>("curve"), Qt::LeftButton);
    window->findChild<QComboBox*>("curve_track")->setCurrentText("Light 1 intensity");
    QCoreApplication::processEvents();
  }
  CurveEditor& editor() { return *window->findChild<CurveEditor*>("curves"); }
  const Keys<glm::dvec3>& keys() { return window->document().scene().lights.at(0).keys.intensity; }
  QPoint at(double time, double value) { return editor().position(time, value).toPoint(); }
  void move(QPointF to, Qt::MouseButton button) {
    QMouseEvent event(QEvent::MouseMove, to, editor().mapToGlobal(to), Qt::NoButton, button, {});
    QApplication::sendEvent(&editor(), &event);
  }
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&editor(), button, {}, from);
    for (int k = 1; k <= 4; ++k) move(QPointF(from) + QPointF(to - from) * k / 4.0, button);
    QTest::mouseRelease(&editor(), button, {}, to);
  }

  TestWindow window;
};

}  // namespace

class CurvesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_dock_opens_and_an_empty_one_teaches() {
    TestWindow window;
    auto* dock = window->findChild<QDockWidget*>("curves_dock");
    QVERIFY(!dock->isVisible());
    auto* button = window->findChild<QToolButton*>("curve");
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(dock->isVisible());
    auto* editor = window->findChild<CurveEditor*>("curves");
    QVERIFY(editor->curves().empty());
    QVERIFY(!window->findChild<QComboBox*>("curve_track")->isEnabled());
    editor->grab();
    QTest::mouseClick(editor, Qt::LeftButton, {}, QPoint(50, 50));
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(!dock->isVisible());
  }

  void a_track_has_a_curve_for_each_number() {
    Curves curves;
    const std::vector<Curve>& shown = curves.editor().curves();
    QCOMPARE(shown.size(), std::size_t{3});
    QCOMPARE(shown[2].component, 2);
    QVERIFY(shown[1].title.endsWith(" g"));
    QCOMPARE(shown[0].at(0.0), 10.0);
    QCOMPARE(shown[0].at(2.0), 20.0);
    QCOMPARE(shown[2].points().back().value, 60.0);
    curves.window->findChild<QComboBox*>("curve_track")->setCurrentText("Light 1 position");
    QVERIFY(curves.editor().curves()[0].title.endsWith(" x"));
  }

  void a_drag_moves_a_key_in_time_and_value_in_one_step() {
    Curves curves;
    Document& document = curves.window->document();
    const Scene before = document.scene();
    const QPoint to = curves.at(2.0, 25.0);
    curves.drag(curves.at(1.0, 10.0), to);
    QCOMPARE(document.undo_stack().count(), 1);
    QCOMPARE(document.undo_stack().undoText(), QString("Move keyframe of light 1 intensity"));
    QCOMPARE(curves.keys().size(), std::size_t{2});
    QVERIFY(std::abs(curves.keys()[0].time - 2.0) < 0.07);
    QVERIFY(std::abs(curves.keys()[0].value.x - 25.0) < 1.0);
    QCOMPARE(curves.keys()[0].value.y, 20.0);
    // On frames.
    const double frame = curves.window->timeline().frame_of(curves.keys()[0].time);
    QVERIFY(std::abs(frame - std::round(frame)) < 1e-9);
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    // Not below what is allowed.
    curves.drag(curves.at(1.0, 10.0), curves.at(1.0, 10.0) + QPoint(0, 2000));
    QCOMPARE(curves.keys()[0].time, 1.0);
    QCOMPARE(curves.keys()[0].value.x, 0.0);
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
  }

  void keys_are_added_and_deleted() {
    Curves curves;
    Document& document = curves.window->document();
    const Scene before = document.scene();
    QTest::mouseDClick(&curves.editor(), Qt::LeftButton, {}, curves.at(2.0, 55.0));
    QCOMPARE(curves.keys().size(), std::size_t{3});
    QVERIFY(std::abs(curves.keys()[1].time - 2.0) < 0.04);
    QVERIFY(std::abs(curves.keys()[1].value.x - 20.0) < 1.0);  // on the curve
    document.undo_stack().undo();
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, {}, curves.at(3.0, 60.0));
    QTest::keyClick(&curves.editor(), Qt::Key_Delete);
    QCOMPARE(curves.keys().size(), std::size_t{1});
    QCOMPARE(document.medium().size(), before.medium.size());
    document.undo_stack().undo();
    QCOMPARE(curves.keys().size(), std::size_t{2});
  }

  void the_view_zooms_pans_fits_and_scrubs() {
    Curves curves;
    CurveEditor& editor = curves.editor();
    const QPointF first = editor.position(1.0, 10.0);
    const QPointF last = editor.position(3.0, 60.0);
    QVERIFY(editor.rect().contains(first.toPoint()) && editor.rect().contains(last.toPoint()));
    const auto wheel = [&](Qt::KeyboardModifiers modifiers) {
      QWheelEvent event(first, editor.mapToGlobal(first), {}, {0, 240}, Qt::NoButton, modifiers,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&editor, &event);
    };
    wheel(Qt::NoModifier);
    QVERIFY(QLineF(editor.position(1.0, 10.0), first).length() < 1e-6);
    QVERIFY(editor.position(3.0, 60.0).x() > last.x());
    QVERIFY(editor.position(3.0, 60.0).y() < last.y());
    const double x = editor.position(3.0, 60.0).x();
    wheel(Qt::ControlModifier);
    QCOMPARE(editor.position(3.0, 60.0).x(), x);
    curves.drag(QPoint(100, 50), QPoint(130, 40), Qt::MiddleButton);
    QVERIFY(QLineF(editor.position(1.0, 10.0), first + QPointF(30, -10)).length() < 1e-6);
    QTest::keyClick(&editor, Qt::Key_Home);
    QVERIFY(QLineF(editor.position(1.0, 10.0), first).length() < 1e-6);
    QTest::mouseClick(&editor, Qt::LeftButton, {}, curves.at(2.0, 58.0));
    QVERIFY(std::abs(curves.window->timeline().frame() - 60) <= 1);
    QCOMPARE(curves.window->document().undo_stack().count(), 0);
  }
};

BRUME_APP_SUITE("curves", CurvesTest)
#include "curves_test.moc"
