// The plate over the camera's frame, and film backs.

#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QPushButton>
#include <fstream>

#include "app/commands/objects/edit_cameras.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/panels/forms/camera_panel.h"
#include "app/panels/forms/plate_panel.h"
#include "app/pictures/picture_viewer.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/viewport.h"
#include "app/widgets/value_field.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/cameras.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// A picture of the scene's shape.
std::filesystem::path plain_picture(const TestWindow& window, const char* name, QColor color) {
  QImage picture(64, 48, QImage::Format_RGB32);
  picture.fill(color);
  picture.save(to_qstring(window.file(name)));
  return window.file(name);
}

std::filesystem::path red_picture(const TestWindow& window) {
  return plain_picture(window, "red.png", Qt::red);
}

// The color over the middle of the camera's frame.
QColor drawn(TestWindow& window) {
  CameraFrame& frame = window.view().camera_frame();
  QImage image(frame.size(), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  frame.render(&image, {}, {}, QWidget::DrawChildren);
  return image.pixelColor(window.view().camera_controller().frame()->center().toPoint());
}

// Whether that is the red picture, as opaque as this.
bool is_drawn(TestWindow& window, double opacity) {
  const QColor color = drawn(window);
  return std::abs(color.alphaF() - opacity) < 0.01 && (opacity == 0.0 || color.red() > 250);
}

Scene tiny_scene_before_a_wall() {
  Scene scene = tiny_scene();
  Surface box;
  box.name = "box";
  box.primitive = Primitive{Primitive::Shape::box, {200.0, 200.0, 0.1}};
  box.mesh = mesh_of(*box.primitive);
  box.translate = scene.camera.target + 2.0 * (scene.camera.target - scene.camera.eye);
  scene.surfaces = {box};
  return scene;
}

// The picture of the view, in a corner of the camera's frame.
QColor shown_in_corner(TestWindow& window) {
  const auto& frame = window.view().camera_controller().frame();
  const QImage& picture = window.shown().picture;
  const QPointF place = frame ? frame->topLeft() + QPointF(6.0, 6.0) : QPointF(6.0, 6.0);
  const double scale = picture.width() / static_cast<double>(window.view().width());
  return picture.pixelColor((place * scale).toPoint());
}

bool is_red(const QColor& color) {
  return color.red() > 240 && color.green() < 12 && color.blue() < 12;
}

PlatePanel& plates(TestWindow& window) {
  return *window->findChild<PlatePanel*>();
}

QString plate_name(TestWindow& window) {
  return window->findChild<QPushButton*>("plate_picture")->text();
}

// Waits until it has been read.
void choose_red_picture(TestWindow& window) {
  plates(window).set_picture(red_picture(window));
  QTRY_COMPARE(plate_name(window), "red.png");
}

// A picture that nothing can read.
std::filesystem::path broken_picture(const TestWindow& window) {
  std::ofstream(window.file("broken.jpg")) << "no picture";
  return window.file("broken.jpg");
}

void delete_camera_beside_another(Document& document) {
  add_camera(document, document.scene().camera);
  delete_camera(document, "Camera");
}

// The scene is open at once: what the panel reads is still being read.
void reopen(TestWindow& window) {
  const std::filesystem::path file = window.file("scene.brume");
  window.document().open(load_document(file), file);
}

}  // namespace

class PlateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_plate_lies_over_the_frame_of_its_camera() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    QVERIFY(is_drawn(window, 0.0));
    QVERIFY(!window->findChild<ValueField*>("plate_opacity")->isEnabled());
    choose_red_picture(window);
    QTRY_VERIFY(is_drawn(window, 0.5));
    enter(window, "plate_opacity", "1");
    QVERIFY(is_drawn(window, 1.0));
    // It is no part of the scene.
    QCOMPARE(step_count(window.document()), 0);
    invoke(window, "view.plate");
    QVERIFY(is_drawn(window, 0.0));
    invoke(window, "view.plate");
    QVERIFY(is_drawn(window, 1.0));

    // Another camera has none; this one keeps it by another name.
    add_camera(window.document(), window.scene().camera);
    QVERIFY(is_drawn(window, 0.0));
    rename_camera(window.document(), "Camera", "Wide");
    use_camera(window.document(), "Wide");
    QTRY_VERIFY(is_drawn(window, 1.0));
    click(window, "plate_remove");
    QVERIFY(is_drawn(window, 0.0));
    QVERIFY(!window->findChild<ValueField*>("plate_opacity")->isEnabled());
  }

  void plates_of_a_sequence_are_those_of_frames() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    plain_picture(window, "p_0003.png", Qt::blue);
    plain_picture(window, "p_0010.png", Qt::green);
    plates(window).set_picture(plain_picture(window, "p_0001.png", Qt::red));
    QTRY_VERIFY(is_drawn(window, 0.5));
    window->timeline().set_frame(3);
    QVERIFY(drawn(window).red() > 250);
    click(window, "plate_sequence");
    QTRY_VERIFY(drawn(window).blue() > 250);
    window->timeline().set_frame(9);
    QTest::qWait(50);
    QVERIFY(drawn(window).blue() > 250);  // the last one up to that frame
    window->timeline().set_frame(10);
    QTRY_VERIFY(drawn(window).green() > 250);
    window->timeline().set_frame(0);
    QTRY_VERIFY(drawn(window).red() > 250);
    QCOMPARE(plate_name(window), "p_0001.png");
    // It is kept in the settings.
    window->document().create();
    QVERIFY(window.open("scene.brume"));
    QVERIFY(window->findChild<QCheckBox*>("plate_sequence")->isChecked());
  }

  void a_plate_comes_back_with_its_scene() {
    TestWindow window(tiny_scene());
    choose_red_picture(window);
    enter(window, "plate_opacity", "0.25");
    window->document().create();
    QCOMPARE(plate_name(window), "Choose…");
    QVERIFY(window.open("scene.brume"));
    QCOMPARE(plate_name(window), "red.png");
    QCOMPARE(value(window, "plate_opacity"), "0.25");
    window.key(Qt::Key_0);
    QTRY_VERIFY(is_drawn(window, 0.25));
  }

  void a_plate_that_cannot_be_read_says_so_and_replaces_none() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    choose_red_picture(window);
    QSignalSpy refused(&plates(window), &PlatePanel::refused);
    plates(window).set_picture(broken_picture(window));
    QTRY_COMPARE(refused.size(), 1);
    QVERIFY2(refused[0][0].toString().contains("broken.jpg"), qPrintable(refused[0][0].toString()));
    QCOMPARE(plate_name(window), "red.png");
    QVERIFY(is_drawn(window, 0.5));
  }

  void a_scene_reopened_while_its_plate_is_read_shows_it() {
    TestWindow window(tiny_scene());
    choose_red_picture(window);
    window->document().create();
    reopen(window);
    reopen(window);
    window.key(Qt::Key_0);
    QTRY_VERIFY(is_drawn(window, 0.5));
  }

  void a_broken_picture_chosen_while_the_plate_is_read_leaves_it() {
    TestWindow window(tiny_scene());
    choose_red_picture(window);
    window->document().create();
    reopen(window);
    QSignalSpy refused(&plates(window), &PlatePanel::refused);
    plates(window).set_picture(broken_picture(window));
    QTRY_COMPARE(refused.size(), 1);
    window.key(Qt::Key_0);
    QTRY_VERIFY(is_drawn(window, 0.5));
  }

  void a_plate_that_is_missing_says_so_and_is_shown_once_it_is_there_again() {
    TestWindow window(tiny_scene());
    choose_red_picture(window);
    std::filesystem::remove(window.file("red.png"));
    QSignalSpy refused(&plates(window), &PlatePanel::refused);
    QVERIFY(window.open("scene.brume"));
    QTRY_COMPARE(refused.size(), 1);
    QVERIFY2(refused[0][0].toString().contains("red.png"), qPrintable(refused[0][0].toString()));
    QCOMPARE(plate_name(window), "red.png");
    window.key(Qt::Key_0);
    QVERIFY(is_drawn(window, 0.0));
    red_picture(window);
    QVERIFY(window.open("scene.brume"));
    window.key(Qt::Key_0);
    QTRY_VERIFY(is_drawn(window, 0.5));
    QCOMPARE(refused.size(), 1);
  }

  void a_chosen_plate_goes_to_its_camera_whatever_happens_while_it_is_read() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    plates(window).set_picture(red_picture(window));
    QTRY_VERIFY(is_drawn(window, 0.5));
    plates(window).set_picture(plain_picture(window, "blue.png", Qt::blue));
    add_camera(window.document(), window.scene().camera);
    rename_camera(window.document(), "Camera", "Wide");
    QCOMPARE(plate_name(window), "Choose…");
    use_camera(window.document(), "Wide");
    QTRY_COMPARE(plate_name(window), "blue.png");
    QTRY_VERIFY(drawn(window).blue() > 250);
    use_camera(window.document(), "Camera 2");
    QCOMPARE(plate_name(window), "Choose…");
  }

  void plates_that_are_chosen_quickly_for_two_cameras_go_to_both() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    plates(window).set_picture(red_picture(window));
    add_camera(window.document(), window.scene().camera);
    plates(window).set_picture(plain_picture(window, "blue.png", Qt::blue));
    plates(window).set_picture(broken_picture(window));
    QTRY_COMPARE(plate_name(window), "blue.png");
    use_camera(window.document(), "Camera");
    QCOMPARE(plate_name(window), "red.png");
    QTRY_VERIFY(is_drawn(window, 0.5));
    // One that is removed while it is read does not come.
    plates(window).set_picture(plain_picture(window, "green.png", Qt::green));
    click(window, "plate_remove");
    plates(window).set_picture(broken_picture(window));
    QSignalSpy refused(&plates(window), &PlatePanel::refused);
    QTRY_COMPARE(refused.size(), 1);
    QCOMPARE(plate_name(window), "Choose…");
  }

  void a_camera_that_is_not_in_use_gets_a_plate() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    add_camera(window.document(), window.scene().camera);
    auto& cameras = *window->findChild<CameraPanel*>();
    cameras.show_camera("Camera");
    plates(window).set_picture(red_picture(window));
    QTRY_COMPARE(plate_name(window), "red.png");
    enter(window, "plate_opacity", "0.25");
    QVERIFY(is_drawn(window, 0.0));
    cameras.show_camera("Camera 2");
    QCOMPARE(plate_name(window), "Choose…");
    use_camera(window.document(), "Camera");
    QTRY_VERIFY(is_drawn(window, 0.25));
  }

  void a_camera_by_the_name_of_a_deleted_one_has_no_plate() {
    TestWindow window(tiny_scene());
    Document& document = window.document();
    choose_red_picture(window);
    delete_camera_beside_another(document);
    add_camera(document, window.scene().camera);
    QCOMPARE(QString::fromStdString(window.scene().camera_name), "Camera");
    QCOMPARE(plate_name(window), "Choose…");
    plates(window).set_picture(plain_picture(window, "blue.png", Qt::blue));
    QTRY_COMPARE(plate_name(window), "blue.png");
    // Each has its own when it is there again.
    document.undo_stack().setIndex(0);
    QCOMPARE(plate_name(window), "red.png");
    document.undo_stack().setIndex(document.undo_stack().count());
    QCOMPARE(plate_name(window), "blue.png");
  }

  void the_plate_of_a_deleted_camera_comes_back_with_it_and_goes_to_no_other() {
    TestWindow window(tiny_scene());
    Document& document = window.document();
    window.key(Qt::Key_0);
    plates(window).set_picture(red_picture(window));
    QTRY_VERIFY(is_drawn(window, 0.5));
    delete_camera_beside_another(document);
    QVERIFY(is_drawn(window, 0.0));
    for (int k = 0; k < 2; ++k) document.undo_stack().undo();
    QTRY_VERIFY(is_drawn(window, 0.5));
    delete_camera_beside_another(document);
    // The settings have forgotten it.
    document.save(document.file());
    QVERIFY(window.open("scene.brume"));
    add_camera(document, window.scene().camera);
    QCOMPARE(QString::fromStdString(window.scene().camera_name), "Camera");
    QCOMPARE(plate_name(window), "Choose…");
    // Nor has a camera it that takes the name.
    choose_red_picture(window);
    delete_camera(document, "Camera");
    rename_camera(document, "Camera 2", "Camera");
    QCOMPARE(plate_name(window), "Choose…");
  }

  void a_plate_behind_the_fog_is_seen_around_it_and_where_surfaces_are_held_out() {
    TestWindow window(tiny_scene_before_a_wall());
    window.key(Qt::Key_0);
    choose_red_picture(window);
    QTRY_VERIFY(is_drawn(window, 0.5));
    QVERIFY(window.settle());
    click(window, "plate_behind");
    QVERIFY(is_drawn(window, 0.0));  // not over it
    QCOMPARE(value(window, "plate_opacity"), "1");
    QVERIFY(window.settle());
    QVERIFY(!is_red(shown_in_corner(window)));  // there is the wall
    auto* holdout = window->findChild<QCheckBox*>("surface_holdout");
    QVERIFY(!holdout->isChecked());
    holdout->click();
    QCOMPARE(last_step(window.document()), "Set holdout of box");
    QTRY_VERIFY(is_red(shown_in_corner(window)));
    QVERIFY(window.settle());
    QVERIFY(is_red(shown_in_corner(window)));
    invoke(window, "view.plate");
    QTRY_VERIFY(!is_red(shown_in_corner(window)));
    invoke(window, "view.plate");
    QTRY_VERIFY(is_red(shown_in_corner(window)));
    window.document().undo_stack().undo();
    QTRY_VERIFY(!is_red(shown_in_corner(window)));
    window.document().undo_stack().redo();
    // It is kept in the settings, and gone with the view through the camera.
    window->document().save(window.file("scene.brume"));
    QVERIFY(window.open("scene.brume"));
    window.key(Qt::Key_0);
    QTRY_VERIFY(is_red(shown_in_corner(window)));
    QVERIFY(window->findChild<QCheckBox*>("plate_behind")->isChecked());
    window.key(Qt::Key_Home);
    QTRY_VERIFY(!is_red(shown_in_corner(window)));
  }

  void a_plate_behind_the_fog_is_no_part_of_airlight_and_of_kept_pictures() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_0);
    choose_red_picture(window);
    QTRY_VERIFY(is_drawn(window, 0.5));
    click(window, "plate_behind");
    QVERIFY(window.settle());
    const DisplayLook look = window.view().frames().display();
    QVERIFY(look.plate);
    QVERIFY(to_picture(window.shown().frame, look, ViewMode::airlight) ==
            to_picture(window.shown().frame, {look.exposure}, ViewMode::airlight));
    invoke(window, "render.keep_view");
    const auto kept = window->findChild<PictureViewer*>()->pictures().at(0);
    QVERIFY(kept && !kept->look.plate);
    QVERIFY(layer_picture(*kept, "airlight"));
  }

  void focal_lengths_are_before_the_chosen_film_back() {
    Desk desk;
    auto* backs = desk.findChild<QComboBox*>("camera_film_back");
    QCOMPARE(backs->currentText(), "36 mm, full frame");
    choose(desk, "camera_lens", 3);
    const double fov = desk.scene().camera.vertical_fov;
    choose(desk, "camera_film_back", 3);
    QCOMPARE(backs->currentText(), "24.89 mm, Super 35");
    QCOMPARE(desk.scene().camera.vertical_fov, fov);  // the picture stays
    QCOMPARE(step_count(desk.document()), 1);
    QCOMPARE(desk.findChild<QComboBox*>("camera_lens")->currentIndex(), -1);
    choose(desk, "camera_lens", 3);
    QCOMPARE(value(desk, "focal_length"), "50");
    const double width = 36.0 / 24.89;
    QVERIFY(std::abs(desk.scene().camera.vertical_fov -
                     vertical_fov(50.0 * width, desk.scene().film)) < 1e-9);
    // It is remembered.
    Desk later;
    QCOMPARE(later.findChild<QComboBox*>("camera_film_back")->currentIndex(), 3);
    choose(later, "camera_film_back", 0);
  }
};

BRUME_APP_SUITE("plate", PlateTest)
#include "plate_test.moc"
