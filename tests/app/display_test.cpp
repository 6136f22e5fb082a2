// Frames of OpenGL in motion are shown without leaving the device. On a machine without a GPU this
// runs on OpenGL in software, which shares objects between contexts and threads just as well.

#include <QAction>
#include <QDeadlineTimer>
#include <QLabel>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/viewport/viewport_surface.h"
#include "app/window/pages/message_bar.h"
#include "render/gl/failures.h"
#include "render/gl_renderer.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// The small scene before a floor and with something of it below.
Scene scene_with_floor(const std::filesystem::path& mesh) {
  write_text(mesh, "OFF\n4 1 0\n-5 -0.7 -5\n5 -0.7 -5\n5 -0.7 5\n-5 -0.7 5\n4 3 2 1 0\n");
  Scene scene = small_scene();
  scene.surfaces.emplace_back().mesh_file = mesh;
  return scene;
}

bool has_stage(const RenderedFrame& frame, Stage stage) {
  return std::ranges::any_of(frame.frame.statistics.stages,
                             [&](const StageTime& ran) { return ran.stage == stage; });
}

int furthest(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 256;
  int max_value = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      max_value = std::max({max_value, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                            std::abs(qBlue(p) - qBlue(q))});
    }
  }
  return max_value;
}

void turn(Viewport& view) {
  Camera camera = view.camera();
  camera.eye.x += 0.1;
  view.camera_controller().set_camera(camera);
}

// A window whose frames are OpenGL's.
class GlWindow : public TestWindow {
 public:
  // Small: OpenGL in software takes its time for each pixel.
  explicit GlWindow(const Scene& scene = small_scene()) : TestWindow(scene, {500, 420}) {
    choose("backend_gl");
    if (!settle() || view().frames().shown()->frame.statistics.backend != "gl") qFatal("no OpenGL");
  }
  ~GlWindow() { choose("backend_auto"); }

  void choose(const char* backend) { (*this)->findChild<QAction*>(backend)->trigger(); }
  // Moves a camera until `look` has seen a frame in motion that was asked for after that began: one
  // that is under way shows what was asked before.
  static bool see_motion(Viewport& view, const std::function<void(const RenderedFrame&)>& look) {
    bool seen = false;
    const double start = view.camera().eye.x;
    const auto connection = QObject::connect(&view.frames(), &FrameScheduler::frame_shown, [&] {
      const FrameRequest& request = view.frames().shown()->request;
      if (!request.moving || request.camera.eye.x <= start || seen) return;
      seen = true;
      look(*view.frames().shown());
    });
    // Again and again: a frame that comes too late would be one at rest.
    const QDeadlineTimer deadline(patience);
    do {
      turn(view);
    } while (!QTest::qWaitFor([&] { return seen; }, 100) && !deadline.hasExpired());
    QObject::disconnect(connection);
    return seen;
  }
  bool see_motion(const std::function<void(const RenderedFrame&)>& look) {
    return see_motion(view(), look);
  }
};

}  // namespace

class DisplayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_frame_in_motion_stays_on_the_device() {
    GlWindow window;
    const auto* stages = window->findChild<QTreeWidget*>("stages");
    QVERIFY(window.see_motion([&](const RenderedFrame& frame) {
      QCOMPARE(frame.frame.statistics.backend, "gl");
      QVERIFY(frame.on_device && frame.picture.isNull());
      QVERIFY(frame.frame.beauty.empty());
      QVERIFY(frame.frame.statistics.view_pairs > 0);
      QVERIFY(has_stage(frame, Stage::display) && !has_stage(frame, Stage::read_back));
      QVERIFY(stages->findItems("display", Qt::MatchExactly).size() == 1);
      QVERIFY(stages->findItems("read_back", Qt::MatchExactly).isEmpty());
    }));
    QVERIFY(window.settle());
    const RenderedFrame& rest = *window.view().frames().shown();
    QVERIFY(!rest.on_device && !rest.picture.isNull());
    QVERIFY(has_stage(rest, Stage::read_back));
    QVERIFY(!rest.frame.beauty.empty());
  }

  void shared_textures_match_downloads() {
    QWidget parent;
    parent.resize(230, 170);
    const ViewportSurfaces surfaces;
    ViewportSurface* surface = surfaces.create(&parent);
    surface->widget()->resize(parent.size());
    parent.show();
    QVERIFY(QTest::qWaitForWindowExposed(&parent, patience));
    const auto seen = [&] { return surface->widget()->grab().toImage(); };

    const auto pool = gl::PicturePool::create();
    const Scene scene = small_scene();
    const Settings settings = sliced_settings({}, 6);
    // Pictures of the surface's size, and stretched over it.
    for (const Film film : {Film{230, 170}, Film{57, 42}}) {
      std::shared_ptr<gl::DevicePicture> picture;
      std::optional<Frame> frame;
      // The picture is made in a thread of its own, as in the editor.
      std::thread([&] {
        std::string problem;
        const auto gl = GlRenderer::create(surfaces.create_context(), nullptr, problem, pool);
        if (!gl) return;
        const gl::DisplayOptions options{.exposure = 1.0};
        picture = gl->show(scene, scene.camera, film, settings, options)->picture;
        frame = gl->render(scene, scene.camera, film, settings);
      }).join();
      QVERIFY(picture && frame);
      surface->show_picture(to_picture(*frame, {1.0}, ViewMode::final));
      const QImage uploaded = seen();
      surface->show_picture(QImage(1, 1, QImage::Format_RGB888));
      QVERIFY(furthest(seen(), uploaded) > 20);
      surface->show_picture(picture);
      QVERIFY2(furthest(seen(), uploaded) <= 1,
               qPrintable(QString::number(furthest(seen(), uploaded))));
      // And again, as when only the handles change.
      surface->show_overlay({});
      QVERIFY(furthest(seen(), uploaded) <= 1);
      surface->show_picture(to_picture(*frame, {1.0}, ViewMode::final));
      QCOMPARE(seen(), uploaded);
    }
  }

  void handles_behind_surfaces_are_known_in_motion() {
    QTemporaryDir folder;
    GlWindow window(scene_with_floor(folder.filePath("floor.off").toStdString()));
    QVERIFY(window.see_motion([&](const RenderedFrame& frame) {
      QVERIFY(frame.on_device);
      const Film film = frame.frame.film;
      QCOMPARE(frame.frame.depth.size(), std::size_t(film.width) * std::size_t(film.height));
      QVERIFY(has_stage(frame, Stage::read_depth) && !has_stage(frame, Stage::read_back));
      QVERIFY(std::ranges::any_of(frame.frame.depth, [](float z) { return std::isfinite(z); }));
    }));
    QVERIFY(window.settle());
    // Nobody asks for it where no handles are to be seen.
    window->tools().activate("paintbrush");
    QVERIFY(window.see_motion([&](const RenderedFrame& frame) {
      QVERIFY(frame.on_device && frame.frame.depth.empty());
      QVERIFY(!has_stage(frame, Stage::read_depth));
    }));
    QVERIFY(window.settle());
    window->tools().activate(0);
  }

  void exposure_and_mode_can_change_in_motion() {
    GlWindow window;
    Viewport& view = window.view();
    QVERIFY(window.see_motion([&](const RenderedFrame&) { view.frames().set_exposure(1.5); }));
    QTRY_VERIFY(view.frames().shown()->request.display.exposure == 1.5);
    QVERIFY(window.settle());
    QVERIFY(
        window.see_motion([&](const RenderedFrame&) { view.frames().set_mode(ViewMode::cost); }));
    QTRY_VERIFY(view.frames().shown()->request.mode == ViewMode::cost);
    QVERIFY(!view.frames().shown()->on_device);  // its picture is the processor's
    QVERIFY(window.settle());
    for (const ViewMode mode : {ViewMode::airlight, ViewMode::outlines, ViewMode::error}) {
      view.frames().set_mode(mode);
      QVERIFY(window.see_motion([&](const RenderedFrame& frame) {
        QVERIFY(frame.on_device);
        QCOMPARE(frame.request.mode, mode);
      }));
    }
    view.frames().set_mode(ViewMode::final);
    QVERIFY(window.settle());
  }

  void the_backend_can_change_while_frames_are_under_way() {
    const std::size_t objects = gl::live_objects();
    {
      GlWindow window;
      for (int k = 0; k < 6; ++k) {
        window.choose(k % 2 == 0 ? "backend_cpu" : "backend_gl");
        turn(window.view());
        QTest::qWait(20 * k);
        turn(window.view());
      }
      QVERIFY(window.settle());
      QCOMPARE(window.view().frames().shown()->frame.statistics.backend, "gl");
      window.choose("backend_cpu");
      QVERIFY(window.see_motion([](const RenderedFrame& frame) {
        QVERIFY(!frame.on_device && !frame.picture.isNull());
      }));
      QVERIFY(window.settle());
      QCOMPARE(window.view().frames().shown()->frame.statistics.backend, "cpu");
    }
    QCOMPARE(gl::live_objects(), objects);
  }

  void views_open_close_and_resize() {
    const std::size_t objects = gl::live_objects();
    {
      GlWindow window;
      auto* grid = window->findChild<ViewGrid*>();
      grid->show_four(true);
      for (int k = 0; k < 4; ++k) {
        window->resize(700 + 60 * k, 500 + 30 * k);
        for (Viewport* pane : grid->panes()) pane->frames().set_exposure(0.1 * k);
        turn(window.view());
        QTest::qWait(60);
      }
      for (Viewport* pane : grid->panes()) {
        pane->setFocus();
        QVERIFY(GlWindow::see_motion(*pane,
                                     [](const RenderedFrame& frame) { QVERIFY(frame.on_device); }));
      }
      window.view().setFocus();
      grid->show_four(false);
      QVERIFY(window.settle());
    }
    QCOMPARE(gl::live_objects(), objects);
  }

  void a_window_can_close_in_motion() {
    const std::size_t objects = gl::live_objects();
    for (int k = 0; k < 3; ++k) {
      GlWindow window;
      if (k % 2 == 0) QVERIFY(window.see_motion([](const RenderedFrame&) {}));
      turn(window.view());
      std::this_thread::sleep_for(std::chrono::milliseconds(15 * k));
    }
    QCOMPARE(gl::live_objects(), objects);
  }

  void a_lost_context_in_motion_falls_back() {
    const std::size_t objects = gl::live_objects();
    {
      GlWindow window;
      gl::failures().context = true;
      QVERIFY(window.see_motion([](const RenderedFrame& frame) {
        QCOMPARE(frame.frame.statistics.backend, "cpu");
        QVERIFY(!frame.on_device && !frame.frame.beauty.empty());
      }));
      gl::failures() = {};
      QVERIFY(window.settle());
      QVERIFY(window->findChild<MessageBar*>()->message().contains("lost"));
      window.choose("backend_gl");
      QVERIFY(window.settle());
      QVERIFY(window.see_motion([](const RenderedFrame& frame) { QVERIFY(frame.on_device); }));
    }
    QCOMPARE(gl::live_objects(), objects);
  }
};

BRUME_APP_SUITE("display", DisplayTest)
#include "display_test.moc"
