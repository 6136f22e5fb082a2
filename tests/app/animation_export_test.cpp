// Frames of an animation, as files and as a video.

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
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

// A fake ffmpeg writes its input to its last argument.
constexpr const char* write_input =
    "for last; do :; done\necho \"$@\" >&2\nexec cat > \"${last#file:}\"\n";

constexpr const char* hang_when_closed = "cat > /dev/null\n: > \"$0.closed\"\nexec sleep 600\n";

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

// An export of frames of the dimming scene into an empty folder of its own.
class Exported {
 public:
  void start(const fs::path& file, int last) {
    FrameExportRequest request;
    request.scene = std::make_shared<const Scene>(dimming_scene());
    request.request.airlight = AirlightMethod::paper;
    request.file = file;
    request.range = {.first = 0, .last = last};
    exporter.start(request);
  }
  fs::path file(const char* name) const { return to_path(folder_.filePath(name)); }
  std::size_t files() const { return files_in(to_path(folder_.path())); }
  // Cancels once `has_begun`; the number of files that were written.
  int cancel_once(const std::function<bool()>& has_begun) {
    if (!QTest::qWaitFor(has_begun, patience)) return -1;
    exporter.job().cancel();
    return cancelled.wait(patience) ? cancelled[0][0].toInt() : -1;
  }

  FrameExport exporter;
  QSignalSpy finished{&exporter, &FrameExport::finished};
  QSignalSpy cancelled{&exporter, &FrameExport::cancelled};
  QSignalSpy failed{&exporter, &FrameExport::failed};

 private:
  QTemporaryDir folder_;
};

// The dialog of a range of frames, and what it asks for.
class Dialog : public AnimationDialog {
 public:
  explicit Dialog(Timeline& timeline) : AnimationDialog(timeline, "/tmp", nullptr) {
    setAttribute(Qt::WA_DeleteOnClose, false);
    show();
  }
  QPushButton& button() { return *findChild<QPushButton*>("export_animation"); }
  QLineEdit& file() { return *findChild<QLineEdit*>("animation_file"); }
  void set_last(int frame) { findChild<QSpinBox*>("animation_last")->setValue(frame); }

  QSignalSpy requests{this, &AnimationDialog::requested};
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
    Exported frames;
    frames.start(frames.file("c.png"), 100'000);
    const int written = frames.cancel_once([&] { return frames.files() > 2; });
    QCOMPARE(frames.files(), static_cast<std::size_t>(written));
    for (int k = 0; k < written; ++k) {
      QCOMPARE(QImage(to_qstring(numbered_file(frames.file("c.png"), k))).size(), QSize(31, 21));
    }
  }

  void ffmpeg_gets_every_frame() {
    const FakeFfmpeg ffmpeg(write_input);
    Exported video;
    video.start(video.file("v.mp4"), 4);
    QVERIFY(video.finished.wait(patience));
    QCOMPARE(fs::file_size(video.file("v.mp4")), std::uintmax_t{31 * 21 * 3 * 5});
  }

  void ffmpeg_errors_are_reported_and_leave_no_file() {
    const FakeFfmpeg ffmpeg("echo no such codec >&2\nexit 1\n");
    Exported video;
    video.start(video.file("v.mp4"), 2);
    QVERIFY(video.failed.wait(patience));
    const QString problem = video.failed[0][0].toString();
    QVERIFY2(problem.contains("v.mp4: cannot be written by ffmpeg: no such codec"),
             qPrintable(problem));
    QCOMPARE(video.files(), 0u);
  }

  void a_cancelled_video_leaves_nothing() {
    const FakeFfmpeg ffmpeg(write_input);
    Exported video;
    video.start(video.file("v.mp4"), 100'000);
    QVERIFY(video.cancel_once([&] { return video.files() > 0; }) >= 0);
    QCOMPARE(video.files(), 0u);
  }

  void ffmpeg_gets_a_name_that_is_no_option_and_no_protocol() {
    const FakeFfmpeg ffmpeg("for last; do :; done\necho \"$last\" >&2\nexit 1\n");
    Exported video;
    fs::create_directory(video.file("http:"));
    const fs::path before = fs::current_path();
    fs::current_path(video.file("http:").parent_path());
    for (const char* name : {"-y.mp4", "http:/x.mp4"}) {
      video.failed.clear();
      video.start(name, 0);
      QVERIFY(video.failed.wait(patience));
      const QString argument = video.failed[0][0].toString().section("by ffmpeg: ", 1);
      QVERIFY2(argument.startsWith("file:/"), qPrintable(argument));
    }
    fs::current_path(before);
  }

  void an_ffmpeg_that_hangs_when_closed_can_be_cancelled() {
    const FakeFfmpeg ffmpeg(hang_when_closed);
    Exported video;
    video.start(video.file("v.mp4"), 1);
    const QString closed = find_ffmpeg() + ".closed";
    QVERIFY(video.cancel_once([&] { return QFile::exists(closed); }) >= 0);
    QCOMPARE(video.files(), 0u);
  }

  void an_ffmpeg_that_hangs_when_closed_lets_the_editor_quit() {
    const FakeFfmpeg ffmpeg(hang_when_closed);
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
    QCOMPARE(files_in(folder), 0u);
  }

  void the_dialog_previews_the_files() {
    const FakeFfmpeg ffmpeg("exit 0\n");
    Timeline timeline(nullptr);
    timeline.set_range(3, 7);
    Dialog dialog(timeline);
    QVERIFY(!dialog.findChild<QLabel*>("no_video")->isVisible());
    dialog.file().setText("/tmp/steam.png");
    dialog.findChild<QComboBox*>("animation_format")->setCurrentIndex(1);
    QCOMPARE(dialog.file().text(), "/tmp/steam.exr");
    dialog.set_last(2);
    QVERIFY(!dialog.button().isEnabled());
    dialog.set_last(5);
    QTest::mouseClick(&dialog.button(), Qt::LeftButton);
    QCOMPARE(dialog.requests.count(), 1);
    QCOMPARE(dialog.requests[0][0].value<fs::path>(), fs::path("/tmp/steam.exr"));
    QCOMPARE(dialog.requests[0][1].toInt(), 3);
    QCOMPARE(dialog.requests[0][2].toInt(), 5);
  }

  void a_frame_before_0_is_refused() {
    Timeline timeline(nullptr);
    timeline.set_range(2, 7);
    Dialog dialog(timeline);
    for (const char* name : {"animation_first", "animation_last"}) {
      auto* box = dialog.findChild<QSpinBox*>(name);
      const int before = box->value();
      box->setFocus();
      box->selectAll();
      QTest::keyClicks(box, "-3");
      const auto is_refused = [&] {
        const auto labels = dialog.findChildren<QLabel*>();
        return !dialog.button().isEnabled() && std::ranges::any_of(labels, [](const QLabel* label) {
          return label->text().contains("must be a whole number from 0 to 1000000");
        });
      };
      QVERIFY2(is_refused(), name);
      QTest::keyClick(box, Qt::Key_Return);
      QVERIFY2(is_refused(), name);
      QCOMPARE(box->value(), before);
      QCOMPARE(box->text(), QString::number(before));
      QTest::keyClicks(box, "\b5");
      QVERIFY2(dialog.button().isEnabled(), name);
    }
    QCOMPARE(dialog.requests.count(), 0);
  }

  void existing_frames_are_replaced_on_confirmation() {
    const QTemporaryDir folder;
    for (const char* name : {"steam_0002.png", "steam_0004.png", "steam_0005.png", "steam_3.png",
                             "steam_0004.exr", "other_0004.png", "steam.mp4"}) {
      std::ofstream(to_path(folder.filePath(name))) << "old";
    }
    Timeline timeline(nullptr);
    Dialog dialog(timeline);
    dialog.findChild<QSpinBox*>("animation_first")->setValue(3);
    dialog.set_last(900'000);
    const auto ask_for = [&](const char* name) {
      dialog.show();
      dialog.file().setText(folder.filePath(name));
    };
    const auto press = [&](QMessageBox::StandardButton chosen) {
      QString question;
      answer(chosen, &question);
      QTest::mouseClick(&dialog.button(), Qt::LeftButton);
      return question;
    };
    ask_for("steam.png");
    const QString asked = press(QMessageBox::Cancel);
    QVERIFY2(asked.contains("2 files") && asked.contains("steam_0004.png") &&
                 asked.contains("steam_0005.png"),
             qPrintable(asked));
    QVERIFY(dialog.isVisible());
    QCOMPARE(dialog.requests.count(), 0);
    press(QMessageBox::Yes);
    QCOMPARE(dialog.requests.count(), 1);
    ask_for("new.png");
    QTest::mouseClick(&dialog.button(), Qt::LeftButton);  // nothing to ask
    QCOMPARE(dialog.requests.count(), 2);
    ask_for("steam.mp4");
    QVERIFY(press(QMessageBox::Cancel).contains("steam.mp4"));
    QCOMPARE(dialog.requests.count(), 2);
  }

  void without_ffmpeg_video_is_disabled() {
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", "/nowhere");
    Timeline timeline(nullptr);
    Dialog dialog(timeline);
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
