// The mouse and keys that move a view's camera.

#include <glm/geometric.hpp>

#include "app/view/surface_picker.h"
#include "brume/mesh_arrays.h"
#include "core/scene/camera_rays.h"
#include "tests/app/desk.h"

using namespace brume;

namespace {

// A box off the middle of the view.
Scene scene_with_box() {
  Scene scene;
  Surface box;
  box.primitive = Primitive{Primitive::Shape::box, glm::dvec3(1.0)};
  box.mesh = mesh_of(*box.primitive);
  box.translate = {1.0, 0.5, 0.0};
  scene.surfaces.push_back(box);
  return scene;
}

// The angle between where two cameras look [radians].
double turn_between(const Camera& a, const Camera& b) {
  return std::acos(
      std::min(1.0, glm::dot(glm::normalize(a.target - a.eye), glm::normalize(b.target - b.eye))));
}

}  // namespace

class NavigationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void orbits_what_is_under_the_mouse() {
    Desk desk(scene_with_box());
    QVERIFY(desk.picks());
    const glm::dvec3 on_box(1.0, 0.5, 0.5);
    const QPoint start = film_position(desk.view(), on_box);
    const Camera before = desk.view().camera();
    desk.drag(start, start + QPoint(60, 25), Qt::MiddleButton);
    const Camera& after = desk.view().camera();
    QVERIFY(turn_between(before, after) > 0.1);
    const double pixel = 0.01 * glm::distance(before.eye, on_box);
    QVERIFY(std::abs(glm::distance(after.eye, on_box) - glm::distance(before.eye, on_box)) < pixel);
    QVERIFY((film_position(desk.view(), on_box) - start).manhattanLength() <= 2);
  }

  void orbits_the_target_where_nothing_is() {
    Desk desk(scene_with_box());
    QVERIFY(desk.picks());
    const Camera before = desk.view().camera();
    desk.drag({20, 20}, {60, 30}, Qt::MiddleButton);
    QVERIFY(glm::distance(desk.view().camera().target, before.target) < 1e-9);
    QVERIFY(desk.view().camera().eye != before.eye);
  }

  void the_right_button_looks_around() {
    Desk desk(scene_with_box());
    const Camera before = desk.view().camera();
    desk.drag({100, 100}, {180, 100}, Qt::RightButton);
    const Camera& after = desk.view().camera();
    QVERIFY(glm::distance(after.eye, before.eye) < 1e-9);
    QVERIFY(turn_between(before, after) > 0.05);
    QVERIFY(CameraRays(before, desk.view().film()).project(after.target).x >
            0.5 * desk.view().film().width);
  }

  void keys_fly_while_the_right_button_is_held() {
    Desk desk(scene_with_box());
    const std::size_t tool = desk.tools().active();
    const auto flown = [&desk](Qt::Key key) {
      const Camera before = desk.view().camera();
      QTest::mousePress(&desk.view(), Qt::RightButton, {}, QPoint(100, 100));
      QTest::keyPress(&desk.view(), key);
      QTest::qWaitFor([&] { return desk.view().camera().eye != before.eye; }, patience);
      QTest::keyRelease(&desk.view(), key);
      QTest::mouseRelease(&desk.view(), Qt::RightButton, {}, QPoint(100, 100));
      const glm::dvec3 way = desk.view().camera().eye - before.eye;
      const CameraRays rays(before, desk.view().film());
      return glm::normalize(glm::dvec3(glm::dot(way, glm::cross(rays.forward(), rays.up())),
                                       glm::dot(way, rays.up()), glm::dot(way, rays.forward())));
    };
    QVERIFY(glm::distance(flown(Qt::Key_W), {0, 0, 1}) < 1e-9);
    QVERIFY(glm::distance(flown(Qt::Key_S), {0, 0, -1}) < 1e-9);
    QVERIFY(glm::distance(flown(Qt::Key_D), {1, 0, 0}) < 1e-9);
    QVERIFY(glm::distance(flown(Qt::Key_A), {-1, 0, 0}) < 1e-9);
    QVERIFY(glm::distance(flown(Qt::Key_E), {0, 1, 0}) < 1e-9);
    QVERIFY(glm::distance(flown(Qt::Key_Q), {0, -1, 0}) < 1e-9);
    QCOMPARE(desk.tools().active(), tool);
    desk.key(Qt::Key_S);  // a shortcut again
    QVERIFY(desk.tools().active() != tool);
  }
};

BRUME_APP_SUITE("navigation", NavigationTest)
#include "navigation_test.moc"
