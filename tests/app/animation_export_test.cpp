// Frames of an animation, as files and as a video.

#include <QComboBox>
#include <QImage>
#include <QLineEdit>
#include <QStandardItemModel>
#include <fstream>

#include "app/document/paths.h"
#include "app/export/frame_export.h"
#include "app/export/render_queue.h"
#include "app/files/picture_format.h"
#include "app/files/scene_files.h"
#include "app/panels/forms/output_panel.h"
#include "app/window/frame_output.h"
#include "core/io/image/image_file.h"
#include "tests/app/desk.h"
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

// Programs are found in one folder only while this lives.
class OtherPath {
 public:
  explicit OtherPath(const QString& folder) : path_(qgetenv("PATH")) {
    qputenv("PATH", folder.toUtf8());
  }
  ~OtherPath() { qputenv("PATH", path_); }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;

 private:
  QByteArray path_;
};

// A folder with a program `ffmpeg`, and nothing else on the PATH.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const char* script) {
    const QString file = folder_.filePath("ffmpeg");
    std::ofstream(file.toStdString()) << "#!/bin/sh\nPATH=/usr/bin:/bin\n" << script;
    QFile::setPermissions(file, QFile::ReadOwner | QFile::ExeOwner);
  }

 private:
  QTemporaryDir folder_;
  OtherPath path_{folder_.path()};
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

// Renders frames by the panel Output.
void render_frames(MainWindow& window, const fs::path& file, int first, int last) {
  type(window, "output_file", to_qstring(file));
  enter(window, "output_first", QString::number(first));
  enter(window, "output_last", QString::number(last));
  click(window, "render.animation_button");
}

}  // namespace

class AnimationExportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_sequence_shows_each_frame_at_its_time() {
    TestWindow window(dimming_scene());
    auto* exporter = window->findChild<FrameExport*>();
    QSignalSpy finished(exporter, &FrameExport::finished);
    render_frames(*window, window.file("a.exr"), 28, 30);
    QVERIFY(finished.wait(patience));
    QVERIFY(!fs::exists(window.file("a_0027.exr")) && !fs::exists(window.file("a_0031.exr")));
    const double before = brightness(window.file("a_0028.exr"));
    const double later = brightness(window.file("a_0029.exr"));
    QVERIFY(before > later && later > 0.0);
    QCOMPARE(brightness(window.file("a_0030.exr")), 0.0);
    render_frames(*window, window.file("a.png"), 0, 0);
    QVERIFY(finished.wait(patience));
    QCOMPARE(QImage(to_qstring(window.file("a_0000.png"))).size(), QSize(31, 21));
  }

  void a_keyed_camera_is_rendered() {
    Scene scene = dimming_scene();
    scene.camera_keys.eye = {{.time = 0.0, .value = {0, 0, 6}},
                             {.time = 0.1, .value = {0, 0, 600}}};
    TestWindow window(scene);
    QSignalSpy finished(window->findChild<FrameExport*>(), &FrameExport::finished);
    render_frames(*window, window.file("k.exr"), 0, 3);
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
    render_frames(*window, folder / "v.mp4", 0, 1);
    const QString closed = find_ffmpeg() + ".closed";
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(closed); }, 60000));
    window.reset();  // the test's time limit is what fails if this waits for ffmpeg
    QCOMPARE(files_in(folder), 0u);
  }

  void the_panel_says_which_files_are_written() {
    const FakeFfmpeg ffmpeg("exit 0\n");
    Desk desk(dimming_scene());
    type(desk, "output_file", "/tmp/steam.png");
    enter(desk, "output_first", "3");
    enter(desk, "output_last", "5");
    choose(desk, "output_format", 1);
    QCOMPARE(desk.findChild<QLineEdit*>("output_file")->text(), "/tmp/steam.exr");
    QCOMPARE(label_text(desk, "output_names"), "Animation: steam_0003.exr to steam_0005.exr");
    choose(desk, "output_format", 3);
    QCOMPARE(label_text(desk, "output_names"), "Frames 3 to 5");
    QSignalSpy refused(desk.findChild<OutputPanel*>(), &OutputPanel::refused);
    for (const char* name : {"output_first", "output_last"}) enter(desk, name, "-3");
    QCOMPARE(refused.size(), 2);
    QCOMPARE(desk.timeline().first(), 3);
    QCOMPARE(desk.timeline().last(), 5);
  }

  void existing_frames_are_replaced_on_confirmation() {
    TestWindow window(dimming_scene());
    for (const char* name : {"steam_0002.png", "steam_0004.png", "steam_0005.png", "steam_3.png",
                             "steam_0004.exr", "other_0004.png", "steam.mp4"}) {
      std::ofstream(window.file(name)) << "old";
    }
    const std::size_t renders = window->output().queue().items().size();
    const auto question_about = [&](const char* name) {
      QString question;
      answer(QMessageBox::Cancel, &question);
      render_frames(*window, window.file(name), 3, 900'000);
      return question;
    };
    const QString asked = question_about("steam.png");
    QVERIFY2(asked.contains("2 files") && asked.contains("steam_0004.png") &&
                 asked.contains("steam_0005.png"),
             qPrintable(asked));
    QVERIFY(question_about("steam.mp4").contains("steam.mp4"));
    QCOMPARE(window->output().queue().items().size(), renders);
  }

  void without_ffmpeg_video_is_disabled() {
    const OtherPath path("/nowhere");
    Desk desk(dimming_scene());
    const auto* format = desk.findChild<QComboBox*>("output_format");
    const QStandardItem* video = qobject_cast<QStandardItemModel*>(format->model())->item(3);
    QVERIFY(!video->isEnabled());
    type(desk, "output_file", "a.mp4");
    QVERIFY(label_text(desk, "output_names").contains("ffmpeg"));
  }
};

BRUME_APP_SUITE("animation_export", AnimationExportTest)
#include "animation_export_test.moc"
