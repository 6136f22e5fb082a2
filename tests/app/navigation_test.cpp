// The mouse and keys that move a view's camera.

#include <glm/geometric.hpp>

#include "app/view/paint_point.h"
#include "app/view/surface_picker.h"
#include "brume/mesh_arrays.h"
#include "core/scene/camera_rays.h"
#include "render/visibility/ray_caster.h"
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

// The same in a room, with the eye near one of its walls.
Scene scene_in_room() {
  Scene scene = scene_with_box();
  Surface room;
  room.primitive = Primitive{Primitive::Shape::box, glm::dvec3(8.0)};
  room.mesh = mesh_of(*room.primitive);
  room.translate = {0.0, 3.0, 0.0};
  scene.surfaces.push_back(room);
  scene.camera.eye = {1.0, 1.0, 3.5};
  scene.camera.target = {1.0, 0.5, 0.5};
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
    const Camera first_camera = desk.view().camera();
    desk.drag(start, start + QPoint(60, 25), Qt::MiddleButton);
    const Camera& moved_camera = desk.view().camera();
    QVERIFY(turn_between(first_camera, moved_camera) > 0.1);
    const double pixel = 0.01 * glm::distance(first_camera.eye, on_box);
    QVERIFY(std::abs(glm::distance(moved_camera.eye, on_box) -
                     glm::distance(first_camera.eye, on_box)) < pixel);
    QVERIFY((film_position(desk.view(), on_box) - start).manhattanLength() <= 2);
  }

  // Out of a room: the wall on the way is left out, and what is in the room stays in sight.
  void walls_before_the_room_are_left_out() {
    Desk desk(scene_in_room());
    QVERIFY(desk.picks());
    const auto seen = [&desk] {
      const RayCaster caster(desk.scene().surfaces);
      const Film film = desk.view().film();
      const SurfaceHit hit =
          caster.first_hit(desk.view().rays(), 0.5 * film.width, 0.5 * film.height);
      return hit ? hit.surface : -1;
    };
    QVERIFY(!desk.view().camera_controller().leaves_out_walls());
    QCOMPARE(seen(), 0);
    // The eye comes nearer to the wall at the right, and passes it.
    desk.view().camera_controller().zoom_by(1.4);
    QVERIFY(desk.view().camera().eye.z > 4.0);
    QVERIFY(desk.view().camera_controller().leaves_out_walls());
    QCOMPARE(seen(), 0);
    QVERIFY(desk.view().camera().clip == Camera().clip);  // what is kept of the view
    // No wall is on the way where it was before.
    desk.view().camera_controller().zoom_by(1.0 / 1.4);
    QVERIFY(!desk.view().camera_controller().leaves_out_walls());

    const QPoint middle = desk.view().rect().center();
    desk.drag(middle, middle + QPoint(desk.view().height() / 4, 0), Qt::MiddleButton);
    const glm::dvec3 eye = desk.view().camera().eye;
    QVERIFY(std::abs(eye.x) < 4.0 && std::abs(eye.z) < 4.0);
    desk.view().camera_controller().zoom_by(2.5);
    QVERIFY(desk.view().camera_controller().leaves_out_walls());
    QCOMPARE(seen(), 0);
    desk.view().camera_controller().reset();
    QVERIFY(!desk.view().camera_controller().leaves_out_walls());
  }

  void walls_that_are_left_out_are_not_picked() {
    Desk desk(scene_in_room());
    QVERIFY(desk.picks());
    const QPointF middle = QRectF(desk.view().rect()).center();
    QCOMPARE(desk.view().visible_surface(middle), std::size_t{0});
    desk.view().camera_controller().zoom_by(1.4);
    QVERIFY(desk.view().camera_controller().leaves_out_walls());
    QCOMPARE(desk.view().visible_surface(middle), std::size_t{0});
    const auto under = desk.view().point_under(middle);
    QVERIFY(under && under->z < 1.0);
    const auto painted = paint_point(desk.view(), {.plane = PaintPlane::surface}, middle, 0.1);
    QVERIFY(painted && painted->position.z < 1.0);
  }

  void an_eye_in_a_wall_is_told() {
    Scene scene = scene_with_box();
    scene.camera.eye = {1.0, 0.5, 0.0};
    scene.camera.target = {1.0, 0.5, -60.0};
    Desk desk(scene);
    QVERIFY(desk.picks());
    QCOMPARE(desk.view().surface_at_eye(), std::size_t{0});
    desk.view().camera_controller().frame_all();
    QVERIFY(!desk.view().surface_at_eye());
  }

  void orbits_the_target_where_nothing_is() {
    Desk desk(scene_with_box());
    QVERIFY(desk.picks());
    const Camera first_camera = desk.view().camera();
    desk.drag({20, 20}, {60, 30}, Qt::MiddleButton);
    QVERIFY(glm::distance(desk.view().camera().target, first_camera.target) < 1e-9);
    QVERIFY(desk.view().camera().eye != first_camera.eye);
  }

  void the_right_button_looks_around() {
    Desk desk(scene_with_box());
    const Camera first_camera = desk.view().camera();
    desk.drag({100, 100}, {180, 100}, Qt::RightButton);
    const Camera& moved_camera = desk.view().camera();
    QVERIFY(glm::distance(moved_camera.eye, first_camera.eye) < 1e-9);
    QVERIFY(turn_between(first_camera, moved_camera) > 0.05);
    QVERIFY(CameraRays(first_camera, desk.view().film()).project(moved_camera.target).x >
            0.5 * desk.view().film().width);
  }

  void keys_fly_while_the_right_button_is_held() {
    Desk desk(scene_with_box());
    const std::size_t tool = desk.tools().active();
    const auto flown = [&desk](Qt::Key key) {
      const Camera first_camera = desk.view().camera();
      QTest::mousePress(&desk.view(), Qt::RightButton, {}, QPoint(100, 100));
      QTest::keyPress(&desk.view(), key);
      const bool has_moved =
          QTest::qWaitFor([&] { return desk.view().camera().eye != first_camera.eye; }, patience);
      QTest::keyRelease(&desk.view(), key);
      QTest::mouseRelease(&desk.view(), Qt::RightButton, {}, QPoint(100, 100));
      if (!has_moved) return glm::dvec3(0.0);
      const glm::dvec3 way = desk.view().camera().eye - first_camera.eye;
      const CameraRays rays(first_camera, desk.view().film());
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

  // A dialog that opens meanwhile is told of the button's release, and of keys.
  void a_dialog_ends_the_flight() {
    Desk desk(scene_with_box());
    const std::size_t tool = desk.tools().active();
    QTest::mousePress(&desk.view(), Qt::RightButton, {}, QPoint(100, 100));
    QDialog dialog(&desk);
    QLineEdit line(&dialog);
    dialog.setModal(true);
    dialog.show();
    QTest::keyClicks(&line, "was");
    QCOMPARE(line.text(), "was");
    dialog.hide();
    const Camera first_camera = desk.view().camera();
    desk.move(QPointF(180, 100), Qt::NoButton);
    QVERIFY(desk.view().camera() == first_camera);
    desk.key(Qt::Key_S);
    QVERIFY(desk.tools().active() != tool);
  }
};

BRUME_APP_SUITE("navigation", NavigationTest)
#include "navigation_test.moc"
