// Named cameras, their lens, and how views show and follow them.

#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

#include "app/document/time/keyframe_tracks.h"
#include "app/panels/forms/key_button.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/timeline_bar.h"
#include "app/view/camera/object_box.h"
#include "app/view/drawing/camera_outline.h"
#include "app/view/drawing/gizmo.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/viewport.h"
#include "app/widgets/value_field.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/camera_rays.h"
#include "core/scene/cameras.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

QStringList cameras(const QWidget& window) {
  QStringList names;
  auto* list = window.findChild<QListWidget*>("cameras");
  for (int k = 0; k < list->count(); ++k) names << list->item(k)->text();
  return names;
}

QString used(const Document& document) {
  return QString::fromStdString(document.scene().camera_name);
}

}  // namespace

class CamerasTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cameras_are_named_used_and_deleted() {
    Desk desk(tiny_scene());
    const Scene before = desk.scene();
    DeskView& view = desk.view();
    desk.drag({300, 300}, {380, 320}, Qt::MiddleButton);
    const Camera seen = view.camera();
    QVERIFY(seen != before.camera);
    click(desk, "add_camera");
    QCOMPARE(cameras(desk), (QStringList{"Camera", "Camera 2"}));
    QCOMPARE(used(desk.document()), "Camera 2");
    QVERIFY(desk.scene().camera == seen);

    auto* list = desk.findChild<QListWidget*>("cameras");
    list->editItem(list->item(1));
    auto* editor = list->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText("Close up");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(used(desk.document()), "Close up");
    QCOMPARE(cameras(desk), (QStringList{"Camera", "Close up"}));

    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
    QCOMPARE(used(desk.document()), "Close up");
    QCOMPARE(value(desk, "camera_eye_z"), "6");
    click(desk, "use_camera");
    QCOMPARE(used(desk.document()), "Camera");
    QVERIFY(desk.scene().camera == before.camera);
    QVERIFY(!desk.findChild<QPushButton*>("use_camera")->isEnabled());
    click(desk, "delete_camera");
    QCOMPARE(used(desk.document()), "Close up");
    QVERIFY(!desk.findChild<QPushButton*>("delete_camera")->isEnabled());
    QVERIFY(desk.scene().camera == seen);
  }

  void a_name_that_is_typed_is_saved() {
    TestWindow window(tiny_scene());
    click(window, "add_camera");
    auto* dock = window->findChild<QDockWidget*>("output_dock");
    dock->show();
    dock->raise();
    window->findChild<QTabWidget*>("output_tabs")->setCurrentIndex(1);
    auto* list = window->findChild<QListWidget*>("cameras");
    QTRY_VERIFY(list->isVisible());
    list->setFocus();
    list->editItem(list->item(1));
    QTest::keyClicks(QApplication::focusWidget(), "Behind");  // which comes first
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!window->document().is_modified());
    QCOMPARE(load_scene(window->document().file()).camera_name, std::string("Behind"));
    QTRY_COMPARE(cameras(*window), (QStringList{"Behind", "Camera"}));
    QCOMPARE(list->currentRow(), 0);
  }

  void focal_length_and_field_of_view_are_one() {
    Desk desk(tiny_scene());
    enter(desk, "focal_length", "50");
    const double fov = desk.scene().camera.vertical_fov;
    QVERIFY(std::abs(fov - vertical_fov(50.0, {32, 24})) < 1e-9);
    enter(desk, "camera_vertical_fov", "90");
    QCOMPARE(value(desk, "focal_length"), "13.5");  // 0.5 * 36 * 24 / 32
    const int steps = step_count(desk.document());
    drag_title(desk, "camera_vertical_fov", 30);
    QCOMPARE(step_count(desk.document()), steps + 1);
    enter(desk, "camera_target_z", "6");  // where the eye is: refused
    QVERIFY(desk.scene().camera.target == glm::dvec3(0.0));
  }

  void roll_is_set_keyed_and_undone() {
    Desk desk(tiny_scene());
    Document& document = desk.document();
    const auto tracks_shown = [&] {
      QStringList titles;
      for (const KeyedTrack& keyed : keyed_tracks(document.scene())) titles << keyed.track.title();
      return titles;
    };
    auto* key = desk.findChild<QToolButton*>("camera_roll_key");
    QVERIFY(key && !key->isChecked());
    // At 0, too, which has no track yet.
    QTest::mouseClick(key, Qt::LeftButton);
    QVERIFY(key->isChecked());
    QCOMPARE(last_step(document), "Set keyframe of camera roll");
    QCOMPARE(tracks_shown(), QStringList{"Camera roll"});
    desk.timeline().set_frame(30);
    QVERIFY(!key->isChecked());
    enter(desk, "camera_roll", "20");  // a key, since it has one
    QVERIFY(key->isChecked());
    QCOMPARE(document.scene().camera.roll, 20.0);
    QCOMPARE(document.scene().camera_keys.roll.size(), 2u);
    desk.timeline().set_frame(15);
    QCOMPARE(value(desk, "camera_roll"), "10");
    desk.timeline().set_frame(30);
    QTest::mouseClick(key, Qt::LeftButton);
    QCOMPARE(last_step(document), "Delete keyframe of camera roll");
    QCOMPARE(document.scene().camera_keys.roll.size(), 1u);
  }

  void a_field_has_the_menu_of_its_keys() {
    Desk desk(tiny_scene());
    auto* key = desk.findChild<KeyButton*>("camera_roll_key");
    QWidget& field = *desk.findChild<ValueField*>("camera_roll");
    QWidget& title = *desk.findChild<QLabel*>("camera_roll_title");
    QVERIFY(!choose_from_menu(title, {3, 3}, "Show Curve"));
    const qint64 plain = key->icon().cacheKey();
    QVERIFY(choose_from_menu(title, {3, 3}, "Insert Keyframe"));
    QVERIFY(key->isChecked());
    QVERIFY(choose_from_menu(*field.findChild<QLineEdit*>(), {3, 3}, "Delete Keyframe"));
    QVERIFY(choose_from_menu(*key, {3, 3}, "Insert Keyframe"));
    desk.timeline().set_frame(30);
    QVERIFY(!key->isChecked());
    QVERIFY(key->icon().cacheKey() != plain);  // in colour: it has keys elsewhere
    enter(desk, "camera_roll", "20");
    QSignalSpy times(key, &KeyButton::time_asked_for);
    QVERIFY(!choose_from_menu(*key, {3, 3}, "Next Keyframe"));
    QVERIFY(choose_from_menu(*key, {3, 3}, "Previous Keyframe"));
    QCOMPARE(times.takeFirst().at(0).toDouble(), 0.0);
    QSignalSpy curves(key, &KeyButton::curve_asked_for);
    QVERIFY(choose_from_menu(*key, {3, 3}, "Show Curve"));
    QCOMPARE(curves.size(), 1);

    desk.timeline().set_frame(60);
    desk.view().setFocus();
    QTest::mouseMove(&title);
    QTRY_VERIFY(title.underMouse());
    QTest::keyClick(&desk.view(), Qt::Key_I);
    QVERIFY(key->isChecked());
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_I, Qt::NoModifier, "i", true);
    QApplication::sendEvent(&desk.view(), &repeated);  // as while it is held
    QVERIFY(key->isChecked());
    QTest::keyClick(&desk.view(), Qt::Key_I);
    QVERIFY(!key->isChecked());
  }

  void orthographic_cameras_are_chosen_set_and_undone() {
    Scene scene = tiny_scene();
    scene.camera.aperture = 0.1;
    Desk desk(scene);
    Document& document = desk.document();
    const Scene before = document.scene();
    const double seen = 2.0 * half_height(before.camera);
    choose(desk, "camera_projection", 1);
    QVERIFY(document.scene().camera.height.has_value());
    QVERIFY(std::abs(*document.scene().camera.height - seen) < 1e-12);
    QCOMPARE(document.scene().camera.aperture, 0.0);
    QCOMPARE(last_step(document), "Set projection");
    for (const char* field : {"focal_length", "camera_vertical_fov", "camera_aperture"}) {
      QVERIFY2(!desk.findChild<ValueField*>(field)->isEnabled(), field);
    }
    enter(desk, "camera_height", "3");
    QCOMPARE(document.scene().camera.height, std::optional(3.0));
    choose(desk, "camera_projection", 0);
    QVERIFY(!document.scene().camera.height);
    QVERIFY(std::abs(2.0 * half_height(document.scene().camera) - 3.0) < 1e-12);
    QVERIFY(is_undone(document, before));
    QCOMPARE(desk.findChild<QComboBox*>("camera_projection")->currentIndex(), 0);
  }

  void views_through_orthographic_cameras_pick_move_and_zoom() {
    Scene scene = tiny_scene();
    scene.camera.height = 3.0;
    Desk desk(scene);
    Document& document = desk.document();
    DeskView& view = desk.view();
    view.camera_controller().look_through_scene_camera();
    QVERIFY(view.camera().height.has_value());
    // The picture is rendered in parallel: handles stand where their Gaussians are.
    const QPoint handle = desk.handle(0);
    QTest::mouseClick(&view, Qt::LeftButton, {}, handle);
    QVERIFY(document.is_selected(document.medium().ids()[0]));
    const CameraRays rays = view.rays();
    QVERIFY(rays.is_parallel());
    // A drag in the plane of the view moves by pixels of one size, wherever that is.
    const glm::dvec3 way = dragged_across({0, 0, -5}, rays, {100, 100}, {110, 100});
    QVERIFY(std::abs(glm::length(way) - 10.0 * rays.pixel_width()) < 1e-9);
    QVERIFY(std::abs(dragged_along({0, 0, -5}, {1, 0, 0}, rays, {100, 100}, {110, 100}) -
                     10.0 * rays.pixel_width()) < 1e-9);
    const Camera camera = view.camera();
    view.camera_controller().zoom_by(0.5);
    QVERIFY(std::abs(*view.camera().height - 1.5) < 1e-12);
    QVERIFY(view.camera().eye == camera.eye);
    view.camera_controller().drag(NavigationDrag::pan, {10.0, 0.0});
    QVERIFY(std::abs(glm::distance(view.camera().eye, camera.eye) -
                     10.0 * view.rays().pixel_width()) < 1e-9);
    view.camera_controller().frame_all();
    QVERIFY(view.camera().height.has_value());
  }

  // However far away the plane of the eye is, and how little is seen.
  void suns_stand_in_the_picture_of_orthographic_cameras() {
    Scene scene = tiny_scene();
    scene.camera.eye *= 100.0;
    scene.camera.height = 3.0;
    scene.lights.push_back({.kind = light::Directional{{-1.0, -1.0, -0.5}}});
    TestWindow window(scene);
    Viewport& view = window->viewport();
    window.key(Qt::Key_0);
    QVERIFY(window.settle());
    for (int k = 0; k < 3; ++k) {
      const CameraRays rays = view.rays();
      const glm::dvec3 sun = rays.project(handle_position(scene.lights.back(), scene, rays));
      QVERIFY(sun.z > 0.0 && view.rect().contains(QPointF(sun.x, sun.y).toPoint()));
      QVERIFY(glm::distance(glm::dvec2(sun), 0.5 * glm::dvec2(view.width(), view.height())) > 30.0);
      view.camera_controller().zoom_by(0.1);
    }
  }

  void the_timeline_keys_what_is_chosen_of_the_camera() {
    Scene scene = tiny_scene();
    scene.camera.aperture = 0.1;
    Desk desk(scene);
    set_key(desk.document(), "Camera aperture");
    auto& sheet = *desk.findChild<DopeSheet*>("keys");
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(1));
    desk.findChild<TimelineBar*>()->set_key();
    QCOMPARE(desk.scene().camera_keys.aperture.size(), 1u);
    QVERIFY(desk.scene().camera_keys.eye.empty());
  }

  void the_frame_of_the_camera_fits_into_the_view() {
    TestWindow window(tiny_scene());
    Viewport& view = window->viewport();
    CameraFrame& frame = view.camera_frame();
    QVERIFY(!frame.isVisible());
    window.key(Qt::Key_0);
    QVERIFY(frame.isVisible());
    const auto frame_is_right = [&] {
      const QRectF rect = *view.camera_controller().frame();
      const Film film = window.scene().film;
      // A point seen at a corner of the film is drawn at that corner of the frame.
      const CameraRays rays(view.camera(), film);
      const glm::dvec3 at = view.rays().project(rays.eye() + 3.0 * rays.direction(0.0, 0.0));
      return QRectF(view.rect()).contains(rect) &&
             QLineF(rect.topLeft(), QPointF(at.x, at.y)).length() < 1e-6 &&
             std::abs(rect.width() / rect.height() -
                      static_cast<double>(film.width) / film.height) < 1e-9;
    };
    QVERIFY(frame_is_right());
    enter(window, "film_width", "200");  // wider than the view
    QVERIFY(frame_is_right());
    QVERIFY(window.settle());
    QVERIFY(view.frames().shown()->request.camera == view.shown_camera());
    enter(window, "film_height", "900");  // upright
    QVERIFY(frame_is_right());
    // Outside the frame the picture is dark.
    QVERIFY(window.settle());
    click(window, "view.camera_frame_box");
    QVERIFY(!frame.isVisible());
    QVERIFY(view.shown_camera() == view.camera());
    click(window, "view.camera_frame_box");
    QVERIFY(frame.isVisible());
    window.drag({300, 300}, {340, 300}, Qt::MiddleButton);  // leaves the camera
    QVERIFY(!frame.isVisible());
    QVERIFY(view.camera() != window.scene().camera);
  }

  void guides_are_drawn_in_the_frame_of_the_camera() {
    TestWindow window(tiny_scene());
    const auto* thirds = window->findChild<QAction*>("view.thirds");
    QVERIFY(!thirds->isEnabled());
    window.key(Qt::Key_0);
    QVERIFY(thirds->isEnabled());
    invoke(window, "view.camera_frame");
    QVERIFY(!thirds->isEnabled());
    invoke(window, "view.camera_frame");
    CameraFrame& frame = window->viewport().camera_frame();
    QVERIFY(frame.isVisible());
    const QRectF inside = *window->viewport().camera_controller().frame();
    // Whether a line passes a place, in fractions of the frame.
    const auto is_drawn = [&](double x, double y) {
      QImage drawn(frame.size(), QImage::Format_ARGB32);
      drawn.fill(Qt::transparent);
      frame.render(&drawn, {}, {}, QWidget::DrawChildren);
      const QPoint place(qRound(inside.left() + x * inside.width()),
                         qRound(inside.top() + y * inside.height()));
      for (int dy = -1; dy <= 1; ++dy) {
        if (qAlpha(drawn.pixel(place + QPoint(0, dy))) > 0) return true;
      }
      return false;
    };
    QVERIFY(!is_drawn(0.5, 1.0 / 3.0));
    invoke(window, "view.thirds");
    QVERIFY(is_drawn(0.5, 1.0 / 3.0));
    QVERIFY(!is_drawn(0.5, 0.05));
    invoke(window, "view.safe_areas");
    QVERIFY(is_drawn(0.5, 0.05) && is_drawn(0.5, 0.1));
    invoke(window, "view.thirds");
    QVERIFY(!is_drawn(0.5, 1.0 / 3.0));
    invoke(window, "view.safe_areas");
  }

  void a_lens_sets_the_field_of_view() {
    Desk desk;
    auto* lenses = desk.findChild<QComboBox*>("camera_lens");
    QCOMPARE(lenses->currentIndex(), -1);
    lenses->setFocus();
    choose(desk, "camera_lens", 3);
    QCOMPARE(lenses->currentText(), "50 mm, normal");
    QVERIFY(std::abs(focal_length(desk.scene().camera.vertical_fov, desk.scene().film) - 50.0) <
            1e-9);
    QCOMPARE(step_count(desk.document()), 1);
    enter(desk, "focal_length", "51");
    QCOMPARE(lenses->currentIndex(), -1);
  }

  void other_views_see_the_camera() {
    const Camera camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 90.0};
    const CameraRays from_above({{0, 50, 0}, {0, 0, 0}, {0, 0, -1}, 20.0}, {400, 400});
    Overlay overlay;
    add_camera_outline(overlay, from_above, camera, {200, 100});
    QVERIFY(!overlay.lines.empty());
    const glm::dvec3 eye = from_above.project(camera.eye);
    QCOMPARE(overlay.lines[0].x, static_cast<float>(eye.x));
    QCOMPARE(overlay.lines[0].y, static_cast<float>(eye.y));
    // At a right angle upwards, twice as far to the sides.
    const glm::dvec3 corner = from_above.project({-8.0, 4.0, 0.0});
    QCOMPARE(overlay.lines[1].x, static_cast<float>(corner.x));
    QCOMPARE(overlay.lines[1].y, static_cast<float>(corner.y));
  }

  void a_view_locked_to_the_camera_moves_it() {
    TestWindow window(tiny_scene());
    Viewport& view = window->viewport();
    const Camera before = window.scene().camera;
    window.key(Qt::Key_0);
    click(window, "view.lock_camera_box");
    window.drag({300, 300}, {380, 330}, Qt::MiddleButton);
    const Camera moved = window.scene().camera;
    QVERIFY(moved != before && view.camera() == moved);
    QVERIFY(view.camera_frame().isVisible());
    QCOMPARE(step_count(window->document()), 1);
    window.drag({300, 300}, {320, 300}, Qt::MiddleButton);
    QCOMPARE(step_count(window->document()), 2);
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.scene().camera == moved && view.camera() == moved);
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.scene().camera == before && view.camera() == before);
    click(window, "view.lock_camera_box");
    window.drag({300, 300}, {320, 300}, Qt::MiddleButton);
    QVERIFY(window.scene().camera == before && view.camera() != before);
  }
};

BRUME_APP_SUITE("cameras", CamerasTest)
#include "cameras_test.moc"
