// The size, region and settings of renders.

#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <numeric>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/pictures/picture_viewer.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/viewport.h"
#include "core/io/image/deep_exr_file.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"
#include "tests/app/listed_queue.h"
#include "tests/app/question.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

}  // namespace

class OutputTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Renders that fail in one test are not in the queue of the next.
  void cleanup() { fs::remove_all(kept_renders_folder()); }

  void the_size_of_the_picture_is_undoable() {
    Desk desk(tiny_scene());
    const auto film = [&] { return desk.scene().film; };
    choose(desk, "size_preset", 1);
    QVERIFY(film() == (Film{1280, 720}));
    QCOMPARE(value(desk, "film_width"), "1280");
    click(desk, "lock_aspect");
    enter(desk, "film_width", "640");
    QVERIFY(film() == (Film{640, 360}));
    enter(desk, "film_height", "0");  // refused
    enter(desk, "film_height", "20000");
    QVERIFY(film() == (Film{640, 360}));
    const int steps = step_count(desk.document());
    drag_title(desk, "film_height", 40);
    QVERIFY(film() == (Film{711, 400}));
    QCOMPARE(step_count(desk.document()), steps + 1);
    desk.document().undo_stack().setIndex(0);
    QVERIFY(film() == (Film{32, 24}));
    QCOMPARE(desk.findChild<QComboBox*>("size_preset")->currentIndex(), 0);
  }

  void output_is_saved_with_the_scene() {
    Desk desk(tiny_scene());
    choose(desk, "output_method", 1);
    enter(desk, "output_paths", "8");
    click(desk, "exposure_of_view");
    enter(desk, "output_exposure", "1.5");
    type(desk, "output_file", "renders/shot");
    QCOMPARE(desk.findChild<QLineEdit*>("output_file")->text(), "renders/shot.png");
    QVERIFY(!desk.findChild<QCheckBox*>("layer_depth")->isEnabled());
    choose(desk, "output_format", 1);
    click(desk, "layer_depth");
    enter(desk, "output_rate", "24");
    enter(desk, "output_last", "48");
    desk.document().save(desk.file("scene.brume"));
    const Scene saved = load_scene(desk.file("scene.brume"));
    QCOMPARE(saved.output.paths, std::optional(8));
    QCOMPARE(saved.output.exposure, std::optional(1.5));
    QVERIFY(saved.output.file == fs::canonical(desk.file(".")) / "renders/shot.exr");
    QVERIFY(!saved.output.layers.depth && saved.output.layers.airlight);
    QVERIFY(saved.playback == (Playback{0, 48, true, 24.0}));
    QCOMPARE(desk.timeline().frames_per_second(), 24.0);
    desk.timeline().set_frame(12);
    QCOMPARE(desk.document().time(), 0.5);

    type(desk, "output_file", "shot.jpg");  // refused
    QVERIFY(desk.scene().output == saved.output);
    desk.document().undo_stack().setIndex(0);
    QVERIFY(desk.scene().output == Output{});
    QCOMPARE(desk.timeline().frames_per_second(), 30.0);
  }

  void samples_lens_and_shutter_are_undoable_and_saved() {
    Desk desk(tiny_scene());
    const Scene before = desk.scene();
    const auto output = [&] { return desk.scene().output; };
    const auto camera = [&] { return desk.scene().camera; };
    click(desk, "samples_chosen");
    QCOMPARE(value(desk, "output_samples"), "16");
    enter(desk, "output_samples", "32");
    enter(desk, "output_samples", "0");  // refused
    QCOMPARE(output().samples, std::optional(32));
    click(desk, "motion_blur");
    QVERIFY(output().shutter == Shutter{});
    enter(desk, "shutter_open", "-0.25");
    enter(desk, "shutter_close", "0.25");
    enter(desk, "shutter_close", "-0.5");  // before it opens: refused
    QVERIFY(output().shutter == (Shutter{-0.25, 0.25}));

    QVERIFY(!desk.findChild<QAbstractButton*>("focus_on_target")->isEnabled());
    enter(desk, "camera_aperture", "0.2");
    click(desk, "focus_on_target");
    QCOMPARE(camera().focus_distance, glm::length(camera().target - camera().eye));
    const int steps = step_count(desk.document());
    drag_title(desk, "camera_focus_distance", 30);
    QCOMPARE(step_count(desk.document()), steps + 1);
    enter(desk, "camera_focus_distance", "4.5");
    QCOMPARE(camera().focus_distance, std::optional(4.5));
    QCOMPARE(camera().aperture, 0.2);

    desk.document().save(desk.file("scene.brume"));
    const Scene saved = load_scene(desk.file("scene.brume"));
    QVERIFY(saved.output == output());
    QVERIFY(saved.camera == camera());
    click(desk, "focus_on_target");
    QVERIFY(!camera().focus_distance);
  }

  // The lens of the scene's camera blurs what is rendered, not the view.
  void renders_have_the_blur_of_the_lens() {
    Scene scene = tiny_scene();
    scene.output.samples = 8;
    TestWindow window(scene);
    type(window, "output_file", "a.exr");
    QVERIFY(render_picture(window));
    enter(window, "camera_aperture", "1");
    enter(window, "camera_target_z", "2");  // before what is there
    type(window, "output_file", "b.exr");
    QVERIFY(render_picture(window));
    const ImageLayers sharp = read_exr(window.file("a.exr"));
    const ImageLayers blurred = read_exr(window.file("b.exr"));
    // The sum of steps between neighbours: blurring makes gradients of them.
    const auto roughness = [](const std::vector<float>& row) {
      double sum = 0.0;
      for (std::size_t i = 1; i < row.size(); ++i) {
        sum += std::pow(static_cast<double>(row[i]) - static_cast<double>(row[i - 1]), 2);
      }
      return sum;
    };
    const double ratio = roughness(blurred.channels.at("R")) / roughness(sharp.channels.at("R"));
    QVERIFY2(ratio < 0.8, qPrintable(QString::number(ratio)));
  }

  void f12_renders_without_a_dialog() {
    TestWindow window(tiny_scene());
    type(window, "output_file", "renders/shot.exr");
    click(window, "layer_depth");
    choose(window, "output_method", 1);
    enter(window, "output_paths", "3");
    QVERIFY(render_picture(window));
    const ImageLayers layers = read_exr(window.file("renders/shot.exr"));
    QCOMPARE(layers.width, 32);
    QVERIFY(layers.channels.contains("airlight.R") && !layers.channels.contains("Z"));
    QVERIFY(layers.metadata.at("brume:airlight") == "path:3");
    auto& viewer = *window->findChild<PictureViewer*>();
    QVERIFY(viewer.isVisible());
    QVERIFY(viewer.pictures().at(0));
    QVERIFY(viewer.pictures().at(0)->details.contains("3 paths"));
    QCOMPARE(viewer.pictures().at(0)->at(5, 6)[0], layers.channels.at("R")[6 * 32 + 5]);

    // Once more, without a question: this session wrote the file.
    QVERIFY(render_picture(window));
    QVERIFY(viewer.pictures().at(1));
    QVERIFY(viewer.findChild<QAbstractButton*>("slot_a_2")->isChecked());
    QVERIFY(viewer.findChild<QAbstractButton*>("slot_b_1")->isChecked());
    QVERIFY(viewer.pictures().at(1)->name == "Camera, frame 0");
  }

  void paths_are_denoised_but_in_layers_of_light() {
    TestWindow window(tiny_scene());
    type(window, "output_file", "shot.exr");
    choose(window, "output_method", 2);
    QVERIFY(window.scene().output.denoise == Denoising::solved);
    enter(window, "output_paths", "4");
    QVERIFY(render_picture(window));
    QCOMPARE(read_exr(window.file("shot.exr")).metadata.at("brume:denoise"), "solved");

    click(window, "layer_lights");
    QVERIFY(render_picture(window));
    const ImageLayers plain = read_exr(window.file("shot.exr"));
    QVERIFY(plain.channels.contains("airlight.light_1.R"));
    QVERIFY(!plain.metadata.contains("brume:denoise"));

    // Pictures without layers are denoised whatever layers are chosen.
    type(window, "output_file", "shot.png");
    QVERIFY(render_picture(window));
    const QImage png(to_qstring(window.file("shot.png")));
    QCOMPARE(png.text("brume:denoise"), "solved");

    window->document().undo_stack().setIndex(0);
    QVERIFY(window.scene().output == Output{});
    QCOMPARE(window->findChild<QComboBox*>("output_method")->currentIndex(), 0);
  }

  void more_layers_are_rendered() {
    TestWindow window(tiny_scene());
    type(window, "output_file", "shot.exr");
    for (const char* box : {"layer_lights", "layer_normal", "layer_objects"}) click(window, box);
    QVERIFY(window.scene().output.layers.objects);
    QVERIFY(render_picture(window));
    const ImageLayers image = read_exr(window.file("shot.exr"));
    for (const char* name : {"Z", "airlight.light_1.R", "normal.X", "CryptoObject00.R"}) {
      QVERIFY2(image.channels.contains(name), name);
    }
    QVERIFY(!image.channels.contains("albedo.R"));
    window->document().undo_stack().undo();
    QVERIFY(!window->findChild<QCheckBox*>("layer_objects")->isChecked());
  }

  // Deep frames are made by slices where the output is path-traced, too.
  void a_name_makes_a_deep_frame() {
    Scene scene = tiny_scene();
    scene.output.paths = 4;
    TestWindow window(scene);
    type(window, "output_file", "shot.deep.exr");
    QVERIFY(!window->findChild<QCheckBox*>("layer_normal")->isEnabled());
    enter(window, "output_first", "2");
    enter(window, "output_last", "2");
    click(window, "render.animation_button");
    QVERIFY(wait_for_renders(window, 1));
    DeepExrHeader header;
    const DeepRows rows = read_deep_exr(window.file("shot_0002.deep.exr"), header);
    QCOMPARE(header.width, 32);
    QVERIFY(header.metadata.contains("brume:deep_error"));
    QVERIFY(!rows.samples.empty());
  }

  void an_animation_asks_for_a_file_and_before_it_replaces() {
    TestWindow window(tiny_scene());
    click(window, "render.animation_button");
    QVERIFY(window->output().queue().items().empty());
    QVERIFY(window->findChild<QLineEdit*>("output_file")->hasFocus());
    type(window, "output_file", "shot.png");
    enter(window, "output_first", "3");
    enter(window, "output_last", "5");
    write_text(window.file("shot_0004.png"), "");
    QString question;
    answer(QMessageBox::Cancel, &question);
    window.key(Qt::Key_F12, Qt::ControlModifier);
    QVERIFY(question.contains("shot_0004.png"));
    QVERIFY(window->output().queue().items().empty());
    answer(QMessageBox::Yes);
    window.key(Qt::Key_F12, Qt::ControlModifier);
    QVERIFY(wait_for_renders(window, 1));
    for (const char* name : {"shot_0003.png", "shot_0004.png", "shot_0005.png"}) {
      QCOMPARE(QImage(to_qstring(window.file(name))).size(), QSize(32, 24));
    }
  }

  void the_queue_renders_the_scene_as_it_was() {
    TestWindow window(tiny_scene());
    window.key(Qt::Key_F12);
    const auto all = window->document().medium().ids();
    window->document().select({all.begin(), all.end()});
    delete_selection(window->document(), "Delete all");
    QVERIFY(render_picture(window));
    const PictureSlots& pictures = window->findChild<PictureViewer*>()->pictures();
    const auto sum = [](const Picture& picture) {
      return std::accumulate(picture.rgb.begin(), picture.rgb.end(), 0.0);
    };
    QVERIFY(sum(*pictures.at(0)) > 0.0);
    QCOMPARE(sum(*pictures.at(1)), 0.0);
  }

  void a_region_is_rendered_alone() {
    TestWindow window(tiny_scene());
    CameraFrame& frame = window->viewport().camera_frame();
    const auto is_marking = [&] { return frame.cursor().shape() == Qt::CrossCursor; };
    window.key(Qt::Key_B, Qt::ControlModifier);
    QVERIFY(frame.isVisible() && is_marking());
    const QRectF rect = *window->viewport().camera_controller().frame();
    const auto at = [&](double x, double y) {
      return QPoint(qRound(rect.left() + x * rect.width()), qRound(rect.top() + y * rect.height()));
    };
    drag_mouse(frame, at(1.2, 1.0), at(0.5, 0.5));
    QVERIFY(frame.region() && !is_marking());
    QVERIFY(window->findChild<QLabel*>("region_text")->text().contains("50 × 50 %"));
    QVERIFY(render_picture(window));
    click(window, "clear_region");
    QVERIFY(!frame.region());
    QVERIFY(render_picture(window));
    const PictureSlots& pictures = window->findChild<PictureViewer*>()->pictures();
    const Picture& part = *pictures.at(0);
    const Picture& whole = *pictures.at(1);
    QCOMPARE(whole.width, 32);
    QVERIFY(std::abs(part.width - 16) <= 1 && std::abs(part.height - 12) <= 1);
    const int x = 32 - part.width;
    const int y = 24 - part.height;
    double most = 0.0;
    for (int k = 0; k < part.height; ++k) {
      most = std::max(most, std::abs(static_cast<double>(part.at(3, k)[0]) -
                                     static_cast<double>(whole.at(x + 3, y + k)[0])));
    }
    QVERIFY(most < 0.02 * static_cast<double>(*std::ranges::max_element(whole.rgb)));
    window.key(Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(&frame, Qt::Key_Escape);
    QVERIFY(!is_marking() && !frame.region());
  }
};

BRUME_APP_SUITE("output", OutputTest)
#include "output_test.moc"
