// Frames of an animation, as files and as a video.

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>
#include <fstream>

#include "app/document/paths.h"
#include "app/document/timeline.h"
#include "app/export/animation_dialog.h"
#include "app/export/frame_export.h"
#include "app/export/video_file.h"
#include "app/files/scene_files.h"
#include "app/viewport/viewport.h"
#include "app/window/frame_output.h"
#include "core/io/image/image_file.h"
#include "tests/app/question.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

// A light that goes out within a second.
Scene dimming_scene() {
  Scene scene = small_scene();
  scene.film = {31, 21};
  scene.lights[0].keys.intensity = {{.time = 0.0, .value = glm::dvec3(12.0)},
                                    {.time = 1.0, .value = glm::dvec3(0.0)}};
  return scene;
}

double brightness(const fs::path& file) {
  const ImageLayers layers = read_exr(file);
  double sum = 0.0;
  for (const float value : layers.channels.at("R")) sum += value;
  return sum;
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// What a fake ffmpeg does to write what it gets to the file that it is given last.
constexpr const char* write_input =
    "for last; do :; done\necho \"$@\" >&2\nexec cat > \"${last#file:}\"\n";

// A folder with a program `ffmpeg`, and nothing else on the PATH.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const char* script) : path_(qgetenv("PATH")) {
    const QString file = folder_.filePath("ffmpeg");
    std::ofstream(file.toStdString()) << "#!/bin/sh\nPATH=/usr/bin:/bin\n" << script;
    QFile::setPermissions(file, QFile::ReadOwner | QFile::ExeOwner);
    qputenv("PATH", folder_.path().toUtf8());
  }
  ~FakeFfmpeg() { qputenv("PATH", path_); }

 private:
  QByteArray path_;
  QTemporaryDir folder_;
};

}  // namespace

class AnimationExportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_sequence_shows_each_frame_at_its_time() {
    TestWindow window(dimming_scene());
    auto* exporter = window->findChild<FrameExport*>();
    QSignalSpy finished(exporter, &FrameExport::finished);
    window->output().export_animation_to(window.file("a.exr"), 28, 30);
    QVERIFY(finished.wait(patience));
    QVERIFY(!fs::exists(window.file("a_0027.exr")) && !fs::exists(window.file("a_0031.exr")));
    const double before = brightness(window.file("a_0028.exr"));
    const double later = brightness(window.file("a_0029.exr"));
    QVERIFY(before > later && later > 0.0);
    QCOMPARE(brightness(window.file("a_0030.exr")), 0.0);
    window->output().export_animation_to(window.file("a.png"), 0, 0);
    QVERIFY(finished.wait(patience));
    QCOMPARE(QImage(to_qstring(window.file("a_0000.png"))).size(), QSize(31, 21));
  }

  void a_keyed_camera_is_rendered() {
    Scene scene = dimming_scene();
    scene.camera_keys.eye = {{.time = 0.0, .value = {0, 0, 6}},
                             {.time = 0.1, .value = {0, 0, 600}}};
    TestWindow window(scene);
    QSignalSpy finished(window->findChild<FrameExport*>(), &FrameExport::finished);
    window->output().export_animation_to(window.file("k.exr"), 0, 3);
    QVERIFY(finished.wait(patience));
    QVERIFY(brightness(window.file("k_0003.exr")) < 0.5 * brightness(window.file("k_0000.exr")));
  }

  void a_cancelled_export_leaves_whole_files_only() {
    TestWindow window(dimming_scene());
    auto* exporter = window->findChild<FrameExport*>();
    const fs::path folder = window.file("out");
    fs::create_directory(folder);
    QSignalSpy cancelled(exporter, &FrameExport::cancelled);
    window->output().export_animation_to(folder / "c.png", 0, 100'000);
    QVERIFY(QTest::qWaitFor([&] { return files_in(folder) > 2; }, patience));
    exporter->job().cancel();
    QVERIFY(cancelled.wait(patience));
    const int written = cancelled[0][0].toInt();
    QCOMPARE(files_in(folder), static_cast<std::size_t>(written));
    for (int k = 0; k < written; ++k) {
      QCOMPARE(QImage(to_qstring(numbered_file(folder / "c.png", k))).size(), QSize(31, 21));
    }
  }

  void ffmpeg_gets_every_frame() {
    const FakeFfmpeg ffmpeg(write_input);
    TestWindow window(dimming_scene());
    QSignalSpy finished(window->findChild<FrameExport*>(), &FrameExport::finished);
    window->output().export_animation_to(window.file("v.mp4"), 0, 4);
    QVERIFY(finished.wait(patience));
    QCOMPARE(fs::file_size(window.file("v.mp4")), std::uintmax_t{31 * 21 * 3 * 5});
  }

  void ffmpeg_errors_are_reported_and_leave_no_file() {
    const FakeFfmpeg ffmpeg("echo no such codec >&2\nexit 1\n");
    TestWindow window(dimming_scene());
    const fs::path folder = window.file("out");
    fs::create_directory(folder);
    QSignalSpy failed(window->findChild<FrameExport*>(), &FrameExport::failed);
    window->output().export_animation_to(folder / "v.mp4", 0, 2);
    QVERIFY(failed.wait(patience));
    QVERIFY2(failed[0][0].toString().contains("v.mp4: cannot be written by ffmpeg: no such codec"),
             qPrintable(failed[0][0].toString()));
    QCOMPARE(files_in(folder), std::size_t{0});
  }

  void a_cancelled_video_leaves_nothing() {
    const FakeFfmpeg ffmpeg(write_input);
    TestWindow window(dimming_scene());
    auto* exporter = window->findChild<FrameExport*>();
    const fs::path folder = window.file("out");
    fs::create_directory(folder);
    QSignalSpy cancelled(exporter, &FrameExport::cancelled);
    window->output().export_animation_to(folder / "v.mp4", 0, 100'000);
    QVERIFY(QTest::qWaitFor([&] { return files_in(folder) > 0; }, patience));
    exporter->job().cancel();
    QVERIFY(cancelled.wait(patience));
    QCOMPARE(files_in(folder), std::size_t{0});
  }

  void ffmpeg_gets_a_name_that_is_no_option_and_no_protocol() {
    const FakeFfmpeg ffmpeg("for last; do :; done\necho \"$last\" >&2\nexit 1\n");
    TestWindow window(dimming_scene());
    fs::create_directory(window.file("http:"));
    const fs::path before = fs::current_path();
    fs::current_path(window.file("http:").parent_path());
    QSignalSpy failed(window->findChild<FrameExport*>(), &FrameExport::failed);
    for (const char* name : {"-y.mp4", "http:/x.mp4"}) {
      failed.clear();
      window->output().export_animation_to(name, 0, 0);
      QVERIFY(failed.wait(60000));
      const QString argument = failed[0][0].toString().section("by ffmpeg: ", 1);
      QVERIFY2(argument.startsWith("file:/"), qPrintable(argument));
    }
    fs::current_path(before);
  }

  void an_ffmpeg_that_hangs_when_closed_can_be_cancelled() {
    const FakeFfmpeg ffmpeg("cat > /dev/null\n: > \"$0.closed\"\nexec sleep 600\n");
    TestWindow window(dimming_scene());
    auto* exporter = window->findChild<FrameExport*>();
    const fs::path folder = window.file("out");
    fs::create_directory(folder);
    QSignalSpy cancelled(exporter, &FrameExport::cancelled);
    window->output().export_animation_to(folder / "v.mp4", 0, 1);
    const QString closed = find_ffmpeg() + ".closed";
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(closed); }, 60000));
    exporter->job().cancel();
    QVERIFY(cancelled.wait(60000));
    QCOMPARE(files_in(folder), std::size_t{0});
  }

  void an_ffmpeg_that_hangs_when_closed_lets_the_editor_quit() {
    const FakeFfmpeg ffmpeg("cat > /dev/null\n: > \"$0.closed\"\nexec sleep 600\n");
    TestWindow scene_of(dimming_scene());
    auto window = std::make_unique<MainWindow>();
    QSignalSpy opened(&window->files(), &SceneFiles::opened);
    window->files().open_file(scene_of.file("scene.brume"));
    QVERIFY(opened.wait(60000));
    const fs::path folder = scene_of.file("out");
    fs::create_directory(folder);
    window->output().export_animation_to(folder / "v.mp4", 0, 1);
    const QString closed = find_ffmpeg() + ".closed";
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(closed); }, 60000));
    window.reset();  // the test's time limit is what fails if this waits for ffmpeg
    QCOMPARE(files_in(folder), std::size_t{0});
  }

  void the_dialog_previews_the_files() {
    const FakeFfmpeg ffmpeg("exit 0\n");
    TestWindow window(dimming_scene());
    window->timeline().set_range(3, 7);
    AnimationDialog dialog(window->timeline(), "/tmp", nullptr);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    QVERIFY(!dialog.findChild<QLabel*>("no_video")->isVisible());
    QSignalSpy requested(&dialog, &AnimationDialog::requested);
    dialog.findChild<QLineEdit*>("animation_file")->setText("/tmp/steam.png");
    dialog.findChild<QComboBox*>("animation_format")->setCurrentIndex(1);
    QCOMPARE(dialog.findChild<QLineEdit*>("animation_file")->text(), QString("/tmp/steam.exr"));
    dialog.findChild<QSpinBox*>("animation_last")->setValue(2);
    auto* button = dialog.findChild<QPushButton*>("export_animation");
    QVERIFY(!button->isEnabled());
    dialog.findChild<QSpinBox*>("animation_last")->setValue(5);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(requested.count(), 1);
    QCOMPARE(requested[0][0].value<fs::path>(), fs::path("/tmp/steam.exr"));
    QCOMPARE(requested[0][1].toInt(), 3);
    QCOMPARE(requested[0][2].toInt(), 5);
  }

  void a_frame_before_0_is_refused() {
    TestWindow window(dimming_scene());
    window->timeline().set_range(2, 7);
    AnimationDialog dialog(window->timeline(), "/tmp", nullptr);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    QSignalSpy requested(&dialog, &AnimationDialog::requested);
    auto* button = dialog.findChild<QPushButton*>("export_animation");
    for (const char* name : {"animation_first", "animation_last"}) {
      auto* box = dialog.findChild<QSpinBox*>(name);
      const int before = box->value();
      box->setFocus();
      box->selectAll();
      QTest::keyClicks(box, "-3");
      const auto is_refused = [&] {
        const auto labels = dialog.findChildren<QLabel*>();
        return !button->isEnabled() && std::ranges::any_of(labels, [](const QLabel* label) {
          return label->text().contains("must be a whole number from 0 to 1000000");
        });
      };
      QVERIFY2(is_refused(), name);
      QTest::keyClick(box, Qt::Key_Return);
      QVERIFY2(is_refused(), name);
      QCOMPARE(box->value(), before);
      QCOMPARE(box->text(), QString::number(before));
      QTest::keyClicks(box, "\b5");
      QVERIFY2(button->isEnabled(), name);
    }
    QCOMPARE(requested.count(), 0);
  }

  void existing_frames_are_replaced_on_confirmation() {
    TestWindow window(dimming_scene());
    for (const char* name : {"steam_0002.png", "steam_0004.png", "steam_0005.png", "steam_3.png",
                             "steam_0004.exr", "other_0004.png"}) {
      std::ofstream(window.file(name)) << "old";
    }
    AnimationDialog dialog(window->timeline(), "/tmp", nullptr);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    QSignalSpy requested(&dialog, &AnimationDialog::requested);
    auto* file = dialog.findChild<QLineEdit*>("animation_file");
    file->setText(to_qstring(window.file("steam.png")));
    dialog.findChild<QSpinBox*>("animation_first")->setValue(3);
    dialog.findChild<QSpinBox*>("animation_last")->setValue(900'000);
    auto* button = dialog.findChild<QPushButton*>("export_animation");
    const auto press = [&](QMessageBox::StandardButton chosen) {
      QString question;
      answer(chosen, &question);
      QTest::mouseClick(button, Qt::LeftButton);
      return question;
    };
    const QString asked = press(QMessageBox::Cancel);
    QVERIFY2(asked.contains("2 files") && asked.contains("steam_0004.png") &&
                 asked.contains("steam_0005.png"),
             qPrintable(asked));
    QVERIFY(dialog.isVisible());
    QCOMPARE(requested.count(), 0);
    press(QMessageBox::Yes);
    QCOMPARE(requested.count(), 1);
    dialog.show();
    file->setText(to_qstring(window.file("new.png")));
    QTest::mouseClick(button, Qt::LeftButton);  // nothing to ask
    QCOMPARE(requested.count(), 2);
    dialog.show();
    std::ofstream(window.file("steam.mp4")) << "old";
    file->setText(to_qstring(window.file("steam.mp4")));
    QVERIFY(press(QMessageBox::Cancel).contains("steam.mp4"));
    QCOMPARE(requested.count(), 2);
  }

  void without_ffmpeg_video_is_disabled() {
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", "/nowhere");
    TestWindow window(dimming_scene());
    AnimationDialog dialog(window->timeline(), "/tmp", nullptr);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    qputenv("PATH", path);
    auto* format = dialog.findChild<QComboBox*>("animation_format");
    const QStandardItem* video = qobject_cast<QStandardItemModel*>(format->model())->item(2);
    QVERIFY(!video->isEnabled());
    QVERIFY(dialog.findChild<QLabel*>("no_video")->isVisible());
    QVERIFY(dialog.findChild<QLabel*>("no_video")->text().contains("ffmpeg"));
  }
};

BRUME_APP_SUITE("animation_export", AnimationExportTest)
#include "animation_export_test.moc"
