// The plate over the camera's frame, and film backs.

#include <QAction>
#include <QComboBox>
#include <QImage>
#include <QPushButton>
#include <fstream>

#include "app/commands/edit_cameras.h"
#include "app/document/paths.h"
#include "app/panels/forms/plate_panel.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/viewport.h"
#include "app/widgets/value_field.h"
#include "core/scene/cameras.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// A red picture of the scene's shape.
std::filesystem::path red_picture(const TestWindow& window) {
  QImage picture(64, 48, QImage::Format_RGB32);
  picture.fill(Qt::red);
  picture.save(to_qstring(window.file("red.png")));
  return window.file("red.png");
}

// What is drawn over the middle of the camera's frame.
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

PlatePanel& plates(TestWindow& window) {
  return *window->findChild<PlatePanel*>();
}

QString plate_name(TestWindow& window) {
  return window->findChild<QPushButton*>("plate_picture")->text();
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
    plates(window).set_picture(red_picture(window));
    QTRY_COMPARE(plate_name(window), "red.png");
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

  void a_plate_comes_back_with_its_scene() {
    TestWindow window(tiny_scene());
    plates(window).set_picture(red_picture(window));
    QTRY_COMPARE(plate_name(window), "red.png");
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
    plates(window).set_picture(red_picture(window));
    QTRY_COMPARE(plate_name(window), "red.png");
    QSignalSpy refused(&plates(window), &PlatePanel::refused);
    std::ofstream(window.file("broken.jpg")) << "no picture";
    plates(window).set_picture(window.file("broken.jpg"));
    QTRY_COMPARE(refused.size(), 1);
    QVERIFY2(refused[0][0].toString().contains("broken.jpg"), qPrintable(refused[0][0].toString()));
    QCOMPARE(plate_name(window), "red.png");
    QVERIFY(is_drawn(window, 0.5));
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
