// How soon designers see what they do: wall time from events of mouse and keys to pictures on
// screen, no display needed (QT_QPA_PLATFORM=offscreen). The scene: 48 Gaussians, a mesh of 2,503
// vertices, an environment, a light, an emitter. Beside milliseconds it prints what part that is of
// the picture at rest, measured in the same run, and how wrong that picture is.
// Or a bank of many Gaussians instead, or the scene of a file.
//   benchmark_gestures [REPEATS [GAUSSIANS | SCENE.brume]]

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/commands/gaussians/select_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/files/scene_files.h"
#include "app/tools/tool_box.h"
#include "app/viewport/viewport.h"
#include "app/widgets/application.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/test_window.h"
#include "tests/random.h"
#include "tools/bench/scenes/benchmark_scenes.h"

using namespace brume;

namespace {

Scene designers_scene() {
  Scene scene = small_scene();
  scene.medium = {};
  Random random(1);
  for (int k = 0; k < 48; ++k) {
    scene.medium.append({random.point(1.0), random.uniform(0.2, 0.5), random.uniform(0.1, 0.6)});
  }
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh_file = BRUME_RESOURCES "/meshes/bunny.obj";
  surface.mesh = read_mesh(surface.mesh_file);
  surface.scale = 0.12;
  surface.translate = {0.0, -0.9, 0.0};
  Environment environment;
  environment.file = BRUME_RESOURCES "/environments/sunset.exr";
  environment.map = read_radiance_map(environment.file);
  environment.intensity = 0.3;
  scene.environment = environment;
  Emitter emitter;
  emitter.position = {0.5, 0.0, 0.5};
  scene.emitters.push_back(emitter);
  return scene;
}

// rms(a - b) / rms(b) of radiance, b averaged over the pixels of the coarser frame a.
double difference(const Frame& a, const Frame& b) {
  const int step = b.film.width / a.film.width;
  double sum = 0.0;
  double whole = 0.0;
  for (int y = 0; y < a.film.height; ++y) {
    for (int x = 0; x < a.film.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        double mean = 0.0;
        for (int j = 0; j < step; ++j) {
          for (int i = 0; i < step; ++i) {
            const int at = (y * step + j) * b.film.width + x * step + i;
            mean +=
                static_cast<double>(b.beauty[static_cast<std::size_t>(4 * at + c)]) / (step * step);
          }
        }
        const auto own = static_cast<std::size_t>(4 * (y * a.film.width + x) + c);
        const double gap = static_cast<double>(a.beauty[own]) - mean;
        sum += gap * gap;
        whole += mean * mean;
      }
    }
  }
  return std::sqrt(sum / whole);
}

class Gestures {
 public:
  Gestures(MainWindow& window, int repeats)
      : window_(window), view_(window.viewport()), repeats_(repeats) {
    QObject::connect(&view_.frames(), &FrameScheduler::frame_shown, &view_, [this] { ++frames_; });
  }

  void run() {
    settle();
    QTest::qWait(500);
    settle();
    at_rest_ = view_.frames().shown()->milliseconds;
    const auto& quality = view_.frames().quality();
    std::printf("picture at rest: %.0f ms, relative RMSE at most %.4f (bound %.2f)\n", at_rest_,
                quality.error() ? quality.error()->airlight.high : -1.0, quality.max_error());
    std::printf("  %s\n", qPrintable(stages_text()));
    std::printf("%-34s first picture [ms]: median, worst, of rest | pictures/s | settled [s]\n",
                "");
    const auto middle = [this] { return view_.rect().center(); };
    gesture("orbit", Qt::MiddleButton, middle);
    choose("paintbrush");
    gesture("paint", Qt::LeftButton, middle);
    choose("eraser");
    gesture("erase", Qt::LeftButton, middle);
    choose("move");
    select_gaussians(window_.document(), some_ids());
    gesture("drag up to 1,000 selected", Qt::LeftButton,
            [this] { return film_position(view_, view_.pivot()); });
    select_gaussians(window_.document(), {});
    choose("select");
    gesture("drag a light", Qt::LeftButton,
            [this] { return film_position(view_, window_.document().scene().lights[0].position); });
    play();
    window_.document().undo_stack().clear();
  }

 private:
  void choose(const char* name) { window_.tools().activate(name); }

  // Those nearest to what the camera looks at.
  [[nodiscard]] std::vector<GaussianId> some_ids() const {
    const Medium& medium = window_.document().medium();
    std::vector<GaussianId> ids(medium.ids().begin(), medium.ids().end());
    const auto distance = [&](GaussianId id) {
      return glm::distance(medium.centers()[*medium.index_of(id)], view_.camera().target);
    };
    const std::size_t count = std::min<std::size_t>(ids.size(), 1000);
    std::ranges::nth_element(ids, ids.begin() + static_cast<std::ptrdiff_t>(count) - 1, {},
                             distance);
    ids.resize(count);
    return ids;
  }

  // Measuring the error of a picture of very many Gaussians takes minutes: once is enough.
  void settle() {
    const bool may_measure = window_.document().medium().size() < 100'000 || at_rest_ == 0.0;
    while (!(may_measure ? view_.frames().is_measured() : view_.frames().is_settled())) {
      QTest::qWait(5);
    }
  }

  // The next picture that is shown, at most ten seconds later.
  double next_picture() {
    QElapsedTimer timer;
    timer.start();
    const int before = frames_;
    while (frames_ == before && timer.elapsed() < 10'000) QCoreApplication::processEvents();
    return 1e-6 * static_cast<double>(timer.nsecsElapsed());
  }

  void gesture(const char* name, Qt::MouseButton button, const std::function<QPoint()>& place) {
    constexpr int duration = 2000;  // milliseconds
    difference_.reset();
    std::vector<double> first;
    std::vector<double> undone;
    double pictures = 0.0;
    double settled = 0.0;
    for (int k = 0; k < repeats_; ++k) {
      settle();
      const QPoint start = place();
      QTest::mouseMove(&view_, start);
      QTest::mousePress(&view_, button, {}, start);
      QCoreApplication::processEvents();
      move_mouse(view_, start + QPoint(6, 2), button);
      first.push_back(next_picture());
      QElapsedTimer timer;
      timer.start();
      const int before = frames_;
      int step = 0;
      while (timer.elapsed() < duration) {
        ++step;
        // Wide loops: a brush paints all along them.
        move_mouse(
            view_,
            start + QPointF(6 + 200.0 * std::sin(0.15 * step), 2 + 90.0 * std::sin(0.1 * step)),
            button);
        QTest::qWait(8);
      }
      pictures += 1e3 * (frames_ - before) / duration;
      if (k == 0) stages_ = stages_text();
      QTest::mouseRelease(&view_, button, {}, start);
      timer.restart();
      std::optional<RenderedFrame> last;  // in motion
      int copied = -1;
      while (!view_.frames().is_settled()) {
        QCoreApplication::processEvents();
        if (frames_ == std::exchange(copied, frames_)) continue;
        const RenderedFrame& shown = *view_.frames().shown();
        if (shown.request.moving) last = shown;
      }
      settled += 1e-3 * static_cast<double>(timer.elapsed());
      const RenderedFrame& rest = *view_.frames().shown();
      if (last && last->request.scene == rest.request.scene &&
          last->request.camera == rest.request.camera) {
        difference_ = difference(last->frame, rest.frame);
      }
      if (!window_.document().undo_stack().canUndo()) continue;
      settle();
      window_.document().undo_stack().undo();
      undone.push_back(next_picture());
    }
    print(name, first, pictures / repeats_, settled / repeats_);
    if (undone.empty()) return;
    std::ranges::sort(undone);
    std::printf("      undone: first picture %.0f ms, worst %.0f\n", undone[undone.size() / 2],
                undone.back());
  }

  void play() {
    difference_.reset();
    // Once through: what is played again comes from the cache.
    const Timeline& timeline = window_.timeline();
    const double whole = 1e3 * timeline.time_of(timeline.last() - timeline.first());
    const int duration = std::min(4000, static_cast<int>(whole));  // milliseconds
    settle();
    QElapsedTimer timer;
    timer.start();
    window_.timeline().play();
    const double first = next_picture();
    const int before = frames_;
    timer.restart();
    while (timer.elapsed() < duration) QTest::qWait(5);
    stages_ = stages_text();
    const double pictures = 1e3 * (frames_ - before) / duration;
    window_.timeline().stop();
    timer.restart();
    while (!view_.frames().is_settled()) QCoreApplication::processEvents();
    print("play", {first}, pictures, 1e-3 * static_cast<double>(timer.elapsed()));
  }

  void print(const char* name, std::vector<double> first, double pictures, double settled) const {
    std::sort(first.begin(), first.end());
    const double median = first[first.size() / 2];
    std::printf("  %-32s %20.0f %7.0f %7.2f      %12.1f   %10.2f\n", name, median, first.back(),
                median / at_rest_, pictures, settled);
    std::printf("      %s", qPrintable(stages_));
    if (difference_) std::printf("; it differs by %.1f %% from that at rest", 100.0 * *difference_);
    std::printf("\n");
    std::fflush(stdout);
  }

  // The pixels of the picture shown, and the stages that took longest.
  [[nodiscard]] QString stages_text() const {
    const RenderedFrame& frame = *view_.frames().shown();
    std::vector<StageTime> times = frame.frame.statistics.stages;
    std::ranges::sort(times, std::ranges::greater{}, &StageTime::milliseconds);
    QString text =
        QString("1/%1 of the width, %2 ms:").arg(frame.divisor).arg(frame.milliseconds, 0, 'f', 0);
    for (std::size_t k = 0; k < std::min<std::size_t>(times.size(), 5); ++k) {
      text +=
          QString(" %1 %2").arg(to_string(times[k].stage)).arg(times[k].milliseconds, 0, 'f', 0);
    }
    if (const auto& solved = frame.frame.statistics.scattering) {
      text += QString(", %1 sweeps").arg(solved->sweeps);
    }
    return text;
  }

  MainWindow& window_;
  Viewport& view_;
  int repeats_;
  int frames_ = 0;
  double at_rest_ = 0.0;
  QString stages_;                    // of a picture in motion
  std::optional<double> difference_;  // of the last one from the picture at rest
};

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir settings;
  prepare_application_in(settings);
  QApplication application(argc, argv);
  set_up_application(application);
  std::filesystem::path file = to_path(settings.filePath("scene.brume"));
  if (argc > 2 && std::string_view(argv[2]).ends_with(".brume")) {
    file = argv[2];
  } else {
    const int gaussians = argc > 2 ? std::clamp(std::atoi(argv[2]), 1, 1'000'000) : 0;
    save_document(gaussians > 0 ? fog_bank(gaussians) : designers_scene(), file);
  }
  MainWindow window;
  show_scene(window, file);
  // Pictures of a half to a sixth of the width then cover the same part of the scene.
  constexpr int divisible = 12;
  const QSize pane = window.viewport().size();
  window.resize(window.width() - pane.width() % divisible,
                window.height() - pane.height() % divisible);
  Gestures(window, argc > 1 ? std::max(1, std::atoi(argv[1])) : 3).run();
  return 0;
}
