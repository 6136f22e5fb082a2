// Drags of handles, keys and titles: what a hand slips in a click is none, and whatever changes the
// scene meanwhile ends them.

#include <QLabel>
#include <QSignalSpy>

#include "app/document/time/timeline.h"
#include "app/panels/time/dope_sheet.h"
#include "app/viewport/viewport.h"
#include "app/widgets/mouse_drag.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

constexpr QPoint slip(2, 2);
constexpr QPoint way(40, 20);

// Two lights, the first with keys.
Scene lit_scene() {
  Scene scene = small_scene();
  Light& light = scene.lights.at(0);
  light.keys.position = {{.time = 0.0, .value = light.position},
                         {.time = 1.0, .value = light.position}};
  scene.lights.push_back(light);
  scene.lights.back().keys = {};
  scene.lights.back().position += glm::dvec3(1.0, -1.5, 0.0);
  return scene;
}

QPoint place_of(const View& view, const Document& document, std::size_t light) {
  return film_position(view, document.scene().lights.at(light).position);
}

void move_to(QWidget& widget, QPoint to) {
  move_mouse(widget, to);
  QCoreApplication::processEvents();
}

void press_and_move(QWidget& widget, QPoint start, QPoint by) {
  QTest::mousePress(&widget, Qt::LeftButton, {}, start);
  move_to(widget, start + by / 2);
  move_to(widget, start + by);
}

// A thing to drag: its widget, and where.
struct Grip {
  const char* name;
  QWidget& widget;
  QPoint start;
};
std::vector<Grip> grips(Desk& desk) {
  desk.key(Qt::Key_V);
  desk.document().select({2});
  auto& keys = *desk.findChild<DopeSheet*>("keys");
  const int frame = static_cast<int>(desk.timeline().frame_of(1.0));
  return {{"light", desk.view(), place_of(desk.view(), desk.document(), 1)},
          {"Gaussian", desk.view(), desk.handle(1)},
          {"keyframe", keys, keys.position(1, frame)},
          {"title", *desk.findChild<QLabel*>("light_intensity_title"), QPoint(3, 3)}};
}

}  // namespace

class DragsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void begin_beyond_a_slip_of_the_hand() {
    MouseDrag drag(nullptr);
    QVERIFY(!drag.has_begun({10, 10}));
    drag.press({10, 10});
    QVERIFY(!drag.has_begun({12, 11}));
    QVERIFY(drag.has_begun({14, 10}));
    QVERIFY2(drag.has_begun({10, 10}), "it may come back");
    drag.release();
    QVERIFY(!drag.has_begun({50, 10}));
    drag.press({10, 10}, true);
    QVERIFY2(drag.has_begun({10, 10}), "a stroke begins at once");
  }

  void are_cancelled_by_escape_and_the_right_button_and_ended_by_other_keys() {
    QWidget widget;
    MouseDrag drag(&widget);
    QSignalSpy cancelled(&drag, &MouseDrag::cancelled);
    QSignalSpy ended(&drag, &MouseDrag::ended);
    drag.press({});
    QTest::keyClick(&widget, Qt::Key_Shift);
    QVERIFY(drag.is_running());
    QTest::keyClick(&widget, Qt::Key_Escape);
    QVERIFY(!drag.is_running());
    QCOMPARE(cancelled.count(), 1);
    drag.press({});
    QTest::mousePress(&widget, Qt::RightButton);
    QCOMPARE(cancelled.count(), 2);
    drag.press({});
    QTest::keyClick(&widget, Qt::Key_Delete);
    QCOMPARE(ended.count(), 1);
    drag.press({}, true);
    QTest::keyClick(&widget, Qt::Key_BracketLeft);
    QVERIFY2(drag.is_running(), "keys change the brush of a stroke");
    drag.release();
    QCOMPARE(ended.count(), 1);
    QCOMPARE(cancelled.count(), 2);
  }

  void of_all_kinds_change_nothing_by_a_slip_or_when_cancelled() {
    Desk desk(lit_scene());
    Document& document = desk.document();
    const auto expect_unchanged = [&](const char* name, const Scene& before) {
      QVERIFY2(document.scene() == before, name);
      QCOMPARE(step_count(document), 0);
    };
    for (const Grip& grip : grips(desk)) {
      const Scene before = document.scene();
      press_and_move(grip.widget, grip.start, slip);
      QTest::mouseRelease(&grip.widget, Qt::LeftButton, {}, grip.start + slip);
      expect_unchanged(grip.name, before);
      press_and_move(grip.widget, grip.start, way);
      QVERIFY2(!(document.scene() == before), grip.name);
      QTest::keyClick(&grip.widget, Qt::Key_Escape);
      expect_unchanged(grip.name, before);
      move_to(grip.widget, grip.start + 2 * way);
      QTest::mouseRelease(&grip.widget, Qt::LeftButton, {}, grip.start + 2 * way);
      expect_unchanged(grip.name, before);
      press_and_move(grip.widget, grip.start, way);
      QTest::mousePress(&grip.widget, Qt::RightButton, {}, grip.start + way);
      expect_unchanged(grip.name, before);
      QTest::mouseRelease(&grip.widget, Qt::RightButton, {}, grip.start + way);
      QTest::mouseRelease(&grip.widget, Qt::LeftButton, {}, grip.start + way);
      expect_unchanged(grip.name, before);
    }
  }

  void end_when_their_light_is_deleted() {
    TestWindow window(lit_scene());
    Document& document = window->document();
    window.key(Qt::Key_V);
    const Light other = document.scene().lights.at(0);
    press_and_move(window->viewport(), place_of(window->viewport(), document, 1), way);
    window.key(Qt::Key_Delete);
    QCOMPARE(document.scene().lights.size(), 1u);
    move_to(window->viewport(), {400, 300});
    QVERIFY2(document.scene().lights.at(0) == other, "the other light stays where it is");
    window.release({400, 300});
    QVERIFY(document.scene().lights.at(0) == other);
  }

  void end_when_they_are_undone() {
    for (const std::size_t k : {0, 1, 2}) {
      Desk desk(lit_scene());
      Document& document = desk.document();
      const Grip grip = grips(desk).at(k);
      const Scene before = document.scene();
      press_and_move(grip.widget, grip.start, way);
      QVERIFY(!(document.scene() == before));
      desk.key(Qt::Key_Z, Qt::ControlModifier);
      move_to(grip.widget, grip.start + 2 * way);
      QTest::mouseRelease(&grip.widget, Qt::LeftButton, {}, grip.start + 2 * way);
      QVERIFY2(document.scene() == before, grip.name);
    }
  }
};

BRUME_APP_SUITE("drags", DragsTest)
#include "drags_test.moc"
