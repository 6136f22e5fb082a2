// Frames come, are right for what is shown, and never hold up the interface.

#include <QAction>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/paths.h"
#include "app/export/frame_export.h"
#include "app/frames/frame_service.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/frame_text.h"
#include "app/window/frame_output.h"
#include "app/window/pages/message_bar.h"
#include "brume/primitive.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/scene_file.h"
#include "render/gl/device.h"
#include "render/gl/failures.h"
#include "render/output/compare.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

bool all_finite(const Frame& frame) {
  const auto finite = [](const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
  };
  return finite(frame.beauty) && finite(frame.airlight) && finite(frame.transmittance);
}

QString shown_settings(MainWindow& window) {
  return window.findChild<QLabel*>("quality")->text();
}

// A frame that takes far longer than a test would wait.
FrameRequest endless_request(std::uint64_t serial) {
  Scene scene = small_scene();
  for (int k = 0; k < 60; ++k) {
    scene.medium.append({{0.03 * k - 1.0, 0.02 * k - 0.5, 0.01 * k}, 0.5, 0.3});
  }
  FrameRequest request;
  request.scene = std::make_shared<const Scene>(scene);
  request.camera = scene.camera;
  request.film = {1600, 1200};
  request.settings.airlight = AirlightMethod::reference;
  request.settings.reference_tolerance = 1e-7;
  request.serial = serial;
  return request;
}

// The small scene with a wavy sheet of n x n vertices that shadows itself.
Scene scene_with_transfer(const std::filesystem::path& mesh, int n) {
  std::ofstream off(mesh);
  off << "OFF\n" << n * n << ' ' << (n - 1) * (n - 1) << " 0\n";
  for (int i = 0; i < n * n; ++i) {
    const double x = 2.0 * (i % n) / (n - 1) - 1.0;
    const double y = 2.0 * (i / n) / (n - 1) - 1.0;
    off << x << ' ' << y << ' ' << 0.2 * std::sin(9.0 * x) * std::sin(9.0 * y) - 1.0 << '\n';
  }
  for (int i = 0; i < n * (n - 1); ++i) {
    if (i % n == n - 1) continue;
    off << "4 " << i << ' ' << i + 1 << ' ' << i + n + 1 << ' ' << i + n << '\n';
  }
  Scene scene = small_scene();
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh_file = mesh;
  surface.transfer = Surface::Transfer::shadow;
  return scene;
}

// The frames that a service makes, as they come.
struct ServedFrames {
  ServedFrames() {
    QObject::connect(&service, &FrameService::frame_ready, &service,
                     [this](const std::shared_ptr<const RenderedFrame>& frame) {
                       last = frame;
                       serials.push_back(frame->request.serial);
                     });
  }

  std::shared_ptr<const RenderedFrame> last;
  std::vector<std::uint64_t> serials;
  FrameService service{std::make_shared<TransferStore>()};
};

bool has_opengl() {
  return qEnvironmentVariableIsEmpty("BRUME_TEST_NO_OPENGL");
}

bool misses_transfer(const Frame& frame) {
  return std::ranges::any_of(frame.statistics.skipped,
                             [](const SkippedStage& s) { return s.stage == Stage::transfer; });
}

}  // namespace

class FramesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_edit_updates_the_frame() {
    TestWindow window;
    Viewport& view = window->viewport();
    QCOMPARE(view.frames().shown()->picture.size(),
             (QSizeF(view.size()) * view.devicePixelRatioF()).toSize());
    QVERIFY(all_finite(view.frames().shown()->frame));
    const QImage before = view.frames().shown()->picture;
    window->document().select({5});
    window.key(Qt::Key_Delete);
    QVERIFY(window.settle());
    QVERIFY(all_finite(view.frames().shown()->frame));
    QVERIFY(view.frames().shown()->picture != before);
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.settle());
    QCOMPARE(view.frames().shown()->picture, before);
  }

  void exposure_changes_the_picture_alone_within_bounds() {
    TestWindow window;
    const RenderedFrame* frame = window->viewport().frames().shown();
    window.key(Qt::Key_Plus);
    QCOMPARE(window->viewport().frames().exposure(), 0.5);
    QCOMPARE(window->viewport().frames().shown(), frame);
    for (int k = 0; k < 50; ++k) window.key(Qt::Key_Plus);
    QCOMPARE(window->viewport().frames().exposure(), 20.0);
    for (int k = 0; k < 100; ++k) window.key(Qt::Key_Minus);
    QCOMPARE(window->viewport().frames().exposure(), -20.0);
  }

  void the_airlight_is_chosen_in_the_menu_and_remembered() {
    {
      TestWindow window;
      auto* paper = window->findChild<QAction*>("airlight_paper");
      auto* automatic = window->findChild<QAction*>("airlight_auto");
      QVERIFY(automatic->isChecked() && !paper->isChecked());
      const QImage before = window.shown().picture;
      QVERIFY(shown_settings(*window).contains("slices"));
      paper->trigger();
      QVERIFY(!automatic->isChecked());
      QVERIFY(window.settle());
      QVERIFY(window.shown().picture != before);
      QVERIFY(shown_settings(*window).startsWith("paper"));
      QVERIFY(!window->document().is_modified());
    }
    TestWindow window;
    QCOMPARE(window->viewport().frames().quality().airlight(), AirlightMethod::paper);
    invoke(window, "airlight_sliced");
    QVERIFY(window.settle());
    QVERIFY(shown_settings(*window).startsWith(QString("%1 slices").arg(Settings{}.slices)));
    invoke(window, "airlight_auto");
  }

  // Or the table of depths from each light would be built anew at every start and stop.
  void motion_keeps_the_tables_of_rest() {
    TestWindow window;
    invoke(window, "airlight_sliced");
    QVERIFY(window.settle());
    Viewport& view = window->viewport();
    const Settings rest = view.frames().shown()->request.settings;
    const RenderedFrame* in_motion = nullptr;
    connect(&view.frames(), &FrameScheduler::frame_shown, this, [&] {
      if (view.frames().shown()->request.moving) {
        in_motion = view.frames().shown();
        QCOMPARE(in_motion->request.settings.optical_depth_table, rest.optical_depth_table);
        QVERIFY(in_motion->request.settings.slices < rest.slices);
        QCOMPARE(in_motion->frame.statistics.light_pairs, std::uint64_t{0});
      }
    });
    Camera camera = view.camera();
    camera.eye.x += 0.1;
    view.camera_controller().set_camera(camera);
    QVERIFY(window.settle());
    QVERIFY(in_motion);
    QVERIFY(view.frames().shown()->request.settings == rest);
    QCOMPARE(view.frames().shown()->frame.statistics.light_pairs, std::uint64_t{0});
    invoke(window, "airlight_auto");
  }

  // Not in motion, and not in the error, which is that of pixels' centers.
  void edges_are_filtered_at_rest() {
    Scene scene = small_scene();
    Surface& surface = scene.surfaces.emplace_back();
    surface.primitive = Primitive{};
    surface.mesh = mesh_of(*surface.primitive);
    TestWindow window(scene);
    QVERIFY(window.settle());
    FrameScheduler& frames = window->viewport().frames();
    QCOMPARE(frames.shown()->request.settings.samples, edge_samples);
    QVERIFY(frames.shown()->frame.statistics.sampled_pixels > 0);
    QVERIFY(frames.is_measured());
    bool moved = false;
    connect(&frames, &FrameScheduler::frame_shown, this, [&] {
      if (!frames.shown()->request.moving) return;
      moved = true;
      QCOMPARE(frames.shown()->request.settings.samples, 1);
    });
    Camera camera = window->viewport().camera();
    camera.eye.x += 0.1;
    window->viewport().camera_controller().set_camera(camera);
    QVERIFY(window.settle());
    QVERIFY(moved);
    QCOMPARE(frames.shown()->request.settings.samples, edge_samples);
  }

  // They are of no use for another scene: coarse ones are built sooner.
  void an_edit_in_motion_takes_coarse_tables() {
    TestWindow window;
    Viewport& view = window->viewport();
    view.frames().quality().set_max_error(1e-9);  // the finest there is
    QVERIFY(window.settle());
    const Settings rest = view.frames().shown()->request.settings;
    bool edited = false;
    connect(&view.frames(), &FrameScheduler::frame_shown, this, [&] {
      const FrameRequest& request = view.frames().shown()->request;
      if (!request.moving) return;
      edited = true;
      QVERIFY(request.settings.optical_depth_table.directions <
              rest.optical_depth_table.directions);
    });
    window.key(Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(window.settle());
    QVERIFY(edited);
    QVERIFY(view.frames().shown()->request.settings == rest);
  }

  void slow_frames_in_motion_do_not_queue_up() {
    ServedFrames frames;
    FrameRequest request = endless_request(1);
    request.settings.reference_tolerance = 1e-3;
    request.film = {200, 150};
    request.moving = true;
    frames.service.request(request);
    QTRY_VERIFY(!frames.serials.empty());
    while (++request.serial <= 50) frames.service.request(request);
    QTRY_VERIFY(frames.serials.back() == 50);
    QVERIFY2(frames.serials.size() < 25, qPrintable(QString::number(frames.serials.size())));
  }

  void a_long_frame_is_cancelled_by_a_newer_one() {
    ServedFrames frames;
    frames.service.request(endless_request(1));
    int ticks = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] { ++ticks; });
    timer.start(10);
    QTRY_VERIFY(ticks >= 10);
    QVERIFY(frames.serials.empty());

    frames.service.request(endless_request(2));
    FrameRequest last = endless_request(3);
    last.film = {40, 30};
    last.settings = {.airlight = AirlightMethod::paper};
    frames.service.request(last);
    QTRY_VERIFY(!frames.serials.empty());
    QCOMPARE(frames.serials, std::vector<std::uint64_t>{3});
  }

  void in_motion_the_resolution_drops() {
    ServedFrames frames;
    FrameRequest request = endless_request(1);
    request.settings = {.airlight = AirlightMethod::paper};
    request.film = {400, 300};
    request.moving = true;
    frames.service.request(request);
    QTRY_VERIFY(frames.last);
    QCOMPARE(frames.last->divisor, 4);
    QCOMPARE(frames.last->frame.film, (Film{100, 75}));
  }

  // Frames come meanwhile, and again once it is there.
  void radiance_transfer_is_made_in_the_background() {
    TestWindow window;
    Viewport& view = window->viewport();
    const JobBar& bar = window.bar(window->views().transfer_job().job());
    save_document(scene_with_transfer(window.file("ball.off"), 100), window.file("transfer.brume"));
    QSignalSpy made(&window->views().transfer_job(), &TransferJob::made);
    QVERIFY(window.open("transfer.brume"));
    QTRY_VERIFY(bar.isVisible());
    QTRY_VERIFY(view.frames().shown() && !view.frames().shown()->request.scene->surfaces.empty());
    QVERIFY(window->views().transfer_job().job().is_running());
    QVERIFY(misses_transfer(view.frames().shown()->frame));
    QVERIFY(made.wait(patience));
    QVERIFY(!bar.isVisible());
    QVERIFY(window.settle());
    QVERIFY(!misses_transfer(view.frames().shown()->frame));
    // An edit of the fog asks for no other.
    window->document().select({5});
    window.key(Qt::Key_Delete);
    QVERIFY(window.settle());
    QVERIFY(!misses_transfer(view.frames().shown()->frame));
    QCOMPARE(made.count(), 1);
  }

  void radiance_transfer_can_be_cancelled() {
    TestWindow window;
    Viewport& view = window->viewport();
    const JobBar& bar = window.bar(window->views().transfer_job().job());
    save_document(scene_with_transfer(window.file("big.off"), 300), window.file("transfer.brume"));
    QVERIFY(window.open("transfer.brume"));
    QTRY_VERIFY(bar.isVisible());
    bar.findChild<QToolButton*>()->click();
    QTRY_VERIFY(!window->views().transfer_job().job().is_running());
    QVERIFY(window.settle());
    QVERIFY(misses_transfer(view.frames().shown()->frame));
    // Another scene gives it up too.
    save_document(scene_with_transfer(window.file("small.off"), 10), window.file("small.brume"));
    QVERIFY(window.open("transfer.brume"));
    QTRY_VERIFY(window->views().transfer_job().job().is_running());
    QSignalSpy made(&window->views().transfer_job(), &TransferJob::made);
    QVERIFY(window.open("small.brume"));
    QTRY_VERIFY(!made.isEmpty());  // perhaps meanwhile
    QVERIFY(window.settle());
    QVERIFY(!misses_transfer(view.frames().shown()->frame));
  }

  void opengl_renders_when_chosen() {
    TestWindow window;
    const auto* shown = window->findChild<QLabel*>("backend");
    const auto render_by = [&](const char* action) {
      invoke(window, action);
      return window.settle() ? window.shown().frame : Frame{};
    };
    const Frame cpu = render_by("backend_cpu");
    QCOMPARE(cpu.statistics.backend, "cpu");
    QCOMPARE(shown->text(), "CPU");
    const Frame gl = render_by("backend_gl");
    const auto* bar = window->findChild<MessageBar*>();
    if (!has_opengl()) {
      QCOMPARE(gl.statistics.backend, "cpu");
      QVERIFY(all_finite(gl));
      QVERIFY(shown->text().startsWith("CPU: "));
      QVERIFY(bar->isVisible() && bar->message().contains("instead of OpenGL"));
    } else {
      QCOMPARE(gl.statistics.backend, "gl");
      QVERIFY(shown->text().contains(QString::fromStdString(gl.statistics.device)));
      QVERIFY(!bar->isVisible());
      const ChannelPair beauty{gl.beauty, cpu.beauty};
      QVERIFY(compare(std::span(&beauty, 1)).rel_rmse < 2e-3);
    }
    // Nobody asks for software.
    const Frame chosen = render_by("backend_auto");
    QVERIFY(!gl::is_software_renderer(chosen.statistics.device));
    QVERIFY(fallback_text(chosen.statistics).isEmpty());
  }

  // And the picture goes on, with a message, until OpenGL is chosen again.
  void the_cpu_takes_over_when_opengl_fails() {
    if (!has_opengl()) return;
    {
      TestWindow window;
      auto* opengl = window->findChild<QAction*>("backend_gl");
      opengl->trigger();
      QVERIFY(window.settle());
      const auto backend = [&] { return window.shown().frame.statistics.backend; };
      QCOMPARE(backend(), "gl");
      gl::failures().context = true;
      window->document().select({5});
      window.key(Qt::Key_Delete);
      QVERIFY(window.settle());
      gl::failures() = {};
      QCOMPARE(backend(), "cpu");
      QVERIFY(all_finite(window.shown().frame));
      auto* bar = window->findChild<MessageBar*>();
      QVERIFY2(bar->isVisible() && bar->message().contains("lost"), qPrintable(bar->message()));
      QVERIFY(window->findChild<QLabel*>("backend")->text().contains("lost"));
      // It is said once.
      bar->hide();
      window.key(Qt::Key_Z, Qt::ControlModifier);
      QVERIFY(window.settle());
      QCOMPARE(backend(), "cpu");
      QVERIFY(!bar->isVisible());
      opengl->trigger();
      QVERIFY(window.settle());
      QCOMPARE(backend(), "gl");
    }
    TestWindow window;
    QVERIFY(window->findChild<QAction*>("backend_gl")->isChecked());
    QCOMPARE(window.shown().frame.statistics.backend, "gl");
    QSignalSpy exported(window->findChild<FrameExport*>(), &FrameExport::finished);
    type(window, "output_file", "frame.exr");
    window.key(Qt::Key_F12);
    QVERIFY(exported.wait(patience));
    QFile file(to_qstring(window.file("frame.exr")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(4096).contains(QByteArray("brume:backend\0string\0\2\0\0\0gl", 27)));
    invoke(window, "backend_auto");
  }

  void export_writes_the_scene_film_in_the_background() {
    TestWindow window;
    auto* exporter = window->findChild<FrameExport*>();
    for (const char* name : {"frame.exr", "frame.png"}) {
      QSignalSpy finished(exporter, &FrameExport::finished);
      type(window, "output_file", name);
      window.key(Qt::Key_F12);
      QVERIFY(exporter->job().is_running());
      QVERIFY(finished.wait(patience));
      QVERIFY(!exporter->job().is_running());
    }
    const ImageLayers layers = read_exr(window.file("frame.exr"));
    QCOMPARE(layers.width, 120);
    QCOMPARE(layers.height, 90);
    QVERIFY(layers.channels.contains("transmittance.G"));
    QCOMPARE(QImage(QString::fromStdString(window.file("frame.png").string())).size(),
             QSize(120, 90));
  }
};

BRUME_APP_SUITE("frames", FramesTest)
#include "frames_test.moc"
