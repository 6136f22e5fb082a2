// Radii and angles of ellipsoids in the inspector: typed and dragged.

#include <QLabel>
#include <functional>

#include "tests/app/desk.h"
#include "tests/app/ellipsoids.h"

using namespace brume;
using namespace brume::ellipsoids;

namespace {

// Drags the title of one of the inspector's numbers by so many steps of 40 pixels, to the left if
// negative; after each `check` is called.
void drag_in_steps(
    const QWidget& window, const char* name, int steps,
    const std::function<void()>& check = [] {}) {
  auto* title = number(window, name).parentWidget()->findChild<QLabel*>();
  QTest::mousePress(title, Qt::LeftButton, {}, QPoint(3, 3));
  QPointF to(3, 3);
  for (int k = 0; k < std::abs(steps); ++k) {
    to.rx() += steps > 0 ? 40 : -40;
    move_mouse(*title, to);
    check();
  }
  QTest::mouseRelease(title, Qt::LeftButton, {}, to.toPoint());
}

// Two ellipsoids among the five, of other rotations about z.
Scene scene_of_two_rotations() {
  Scene scene = scene_of_ellipsoids();
  Medium medium;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian gaussian = scene.medium.gaussian(i);
    if (i == 1) gaussian.shape.rotation = from_euler_angles({0.0, 88.0, 30.0});
    if (i == 2) gaussian.shape.rotation = from_euler_angles({0.0, 88.0, 40.0});
    medium.append(gaussian);
  }
  scene.medium = medium;
  return scene;
}

}  // namespace

class EllipsoidInspectorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void radii_and_rotation_in_the_inspector() {
    Desk desk;
    Document& document = desk.document();
    document.select({1, 2});
    QCOMPARE(number(desk, "radius_x").text(), number(desk, "radius").text());  // both mixed
    QVERIFY(!number(desk, "rotation_x").isVisible());
    type_into(desk, "radius", "0.5");
    QCOMPARE(number(desk, "radius_y").text(), "0.5");
    type_into(desk, "radius_z", "0.8");
    QCOMPARE(last_step(document), "Set radius z of 2 Gaussians to 0.8");
    QCOMPARE(number(desk, "radius").text(), "0.8");
    QCOMPARE(number(desk, "radius_x").text(), "0.5");
    for (const std::size_t k : {0U, 1U}) {
      QVERIFY(is_near(gaussian(document, k).radii(), {0.5, 0.5, 0.8}));
    }
    QVERIFY(number(desk, "rotation_x").isVisible());
    type_into(desk, "rotation_y", "130");
    type_into(desk, "rotation_x", "15");
    QCOMPARE(last_step(document), "Set rotation x of 2 Gaussians to 15");
    QCOMPARE(number(desk, "rotation_y").text(), "130");  // as entered
    QCOMPARE(gaussian(document, 1).shape.rotation, from_euler_angles({15.0, 130.0, 0.0}));
    QCOMPARE(gaussian(document, 2).shape, GaussianShape());
    // The one radius scales all.
    type_into(desk, "radius", "1.6");
    QVERIFY(is_near(gaussian(document, 0).radii(), {1.0, 1.0, 1.6}));
    // Another value of one of them is shown as mixed for both.
    document.select({1});
    type_into(desk, "rotation_z", "40");
    type_into(desk, "radius_y", "0.3");
    document.select({1, 2});
    QCOMPARE(number(desk, "radius_x").text(), "1");
    QVERIFY(number(desk, "radius_y").text() != QString("0.3"));
    QVERIFY(number(desk, "rotation_z").text() != QString("40"));
    type_into(desk, "radius_y", "*2");
    QVERIFY(is_near(gaussian(document, 0).radii(), {1.0, 0.6, 1.6}));
    QVERIFY(is_near(gaussian(document, 1).radii(), {1.0, 2.0, 1.6}));
    // Equal radii make balls.
    for (const char* field : {"radius_x", "radius_y", "radius_z"}) type_into(desk, field, "0.5");
    for (const std::size_t k : {0U, 1U}) {
      QVERIFY(gaussian(document, k).is_ball());
      QCOMPARE(gaussian(document, k).radius, 0.5);
    }
  }

  void dragging_an_angle_is_one_step_and_goes_round() {
    const Scene before = scene_of_ellipsoids();
    Desk desk(before);
    Document& document = desk.document();
    document.select({2});
    const int count = step_count(document);
    drag_in_steps(desk, "rotation_y", 10);
    QCOMPARE(step_count(document), count + 1);
    // Half a degree a pixel, past 90.
    QVERIFY(is_turned(gaussian(document, 1), {10.0, 220.0, 30.0}));
    QCOMPARE(gaussian(document, 1).radii(), before.medium.gaussian(1).radii());
  }

  void angles_of_several_go_past_90_together() {
    const Scene before = scene_of_two_rotations();
    Desk desk(before);
    Document& document = desk.document();
    document.select({2, 3});
    QCOMPARE(number(desk, "rotation_y").text(), "88");
    double shown = 88.0;
    drag_in_steps(desk, "rotation_y", 4, [&] {
      shown += 20.0;
      QCOMPARE(number(desk, "rotation_y").text(), QString::number(shown));
      QVERIFY(is_turned(gaussian(document, 1), {0.0, shown, 30.0}));
      QVERIFY(is_turned(gaussian(document, 2), {0.0, shown, 40.0}));
    });
    QCOMPARE(step_count(document), 1);
    QCOMPARE(number(desk, "rotation_x").text(), "0");
    document.undo_stack().undo();
    QCOMPARE(number(desk, "rotation_y").text(), "88");
    for (int k = 0; k < 2; ++k) {
      type_into(desk, "rotation_y", "130");
      QVERIFY(is_turned(gaussian(document, 1), {0.0, 130.0, 30.0}));
      QVERIFY(is_turned(gaussian(document, 2), {0.0, 130.0, 40.0}));
    }
    // Each has the angles that were entered, whatever is edited in between.
    document.select({2});
    type_into(desk, "rotation_x", "5");
    document.select({3});
    QCOMPARE(number(desk, "rotation_y").text(), "130");
    QCOMPARE(number(desk, "rotation_z").text(), "40");
  }

  void changes_of_angles_are_of_those_shown() {
    const Scene before = scene_of_two_rotations();
    Desk desk(before);
    Document& document = desk.document();
    document.select({1, 2, 3});
    type_into(desk, "rotation_y", "130");
    // The ball does not turn.
    QCOMPARE(last_step(document), "Set rotation y of 2 Gaussians to 130");
    type_into(desk, "rotation_y", "+10");
    QCOMPARE(last_step(document), "Change rotation y of 2 Gaussians");
    QVERIFY(is_turned(gaussian(document, 1), {0.0, 140.0, 30.0}));
    QVERIFY(is_turned(gaussian(document, 2), {0.0, 140.0, 40.0}));
    document.select({2, 3});
    QCOMPARE(number(desk, "rotation_y").text(), "140");
    type_into(desk, "rotation_y", "*2");
    type_into(desk, "rotation_y", "-=30");
    QCOMPARE(number(desk, "rotation_y").text(), "250");
    type_into(desk, "rotation_z", "*2");  // of what differs
    QVERIFY(is_turned(gaussian(document, 1), {0.0, 250.0, 60.0}));
    QVERIFY(is_turned(gaussian(document, 2), {0.0, 250.0, 80.0}));
  }

  void a_radius_dragged_through_a_ball_keeps_the_rotation() {
    Scene before = small_scene();
    before.medium = Medium();
    before.medium.append(ellipsoid({}, {1.0, 1.0, 0.5}, {10.0, 20.0, 30.0}));
    Desk desk(before);
    Document& document = desk.document();
    document.select({1});
    const double factor = std::pow(1.01, 40);
    type_into(desk, "radius_z", QString::number(1.0 / factor, 'f', 12));
    bool was_ball = false;
    // The title is a pixel's hundredth of the value; it rounds to four digits.
    drag_in_steps(desk, "radius_z", 2,
                  [&] { was_ball = was_ball || gaussian(document, 0).is_ball(); });
    QVERIFY(was_ball);
    QCOMPARE(gaussian(document, 0).radii().z, 1.489);
    QVERIFY(is_turned(gaussian(document, 0), {10.0, 20.0, 30.0}));
    QCOMPARE(step_count(document), 2);
    // One of its own is made from a ball as it is.
    for (int k = 0; k < 3; ++k) type_into(desk, "radius_z", "1");
    QVERIFY(gaussian(document, 0).is_ball());
    drag_in_steps(desk, "radius_z", 1);
    QVERIFY(is_turned(gaussian(document, 0), {0.0, 0.0, 0.0}));
  }
};

BRUME_APP_SUITE("ellipsoid_inspector", EllipsoidInspectorTest)
#include "ellipsoid_inspector_test.moc"
