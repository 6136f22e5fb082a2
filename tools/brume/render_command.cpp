#include <tbb/global_control.h>
#include <tbb/info.h>

#include <chrono>
#include <vector>

#include "core/io/disk/atomic_file.h"
#include "core/io/image/image_file.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/frame_sequence.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/read_scene.h"
#include "tools/brume/render_options.h"
#include "tools/brume/render_statistics.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

class RenderCommand final : public Command {
 public:
  explicit RenderCommand(CLI::App& app) : options_(app) {}

  ExitCode run() override {
    options_.check();
    // Frames have their own arenas; this also limits everything else.
    const int threads = options_.request({}).threads.value_or(tbb::info::default_concurrency());
    const tbb::global_control bound(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    set_image_threads(threads);
    return options_.is_sequence() ? render_sequence(options_) : render_one();
  }

 private:
  ExitCode render_one() {
    CommandFiles files = options_.outputs();
    const Clock::time_point start = Clock::now();
    const Scene scene = options_.adjusted(read_scene(options_.scene_file(), files));
    const FrameInfo info = options_.info();
    if (info.look.view) print_warnings(info.look.view->warnings());
    SceneRenderer renderer;
    const Frame frame = render(renderer, scene, options_.request(scene.film), 1);
    RenderRun run{.scene = options_.scene_file(), .repeat = options_.repeat()};
    run.first_frame_milliseconds =
        Milliseconds(Clock::now() - start).count() - frame.statistics.extra_milliseconds;
    print_warnings(frame.warnings);
    const std::vector<FrameStatistics> moved = moved_frames(renderer, scene, frame);
    if (options_.is_deep()) {
      run.deep = write_deep(renderer, options_.output(), scene, frame, info);
    } else {
      write_frame(options_.output(), frame, info);
    }
    if (!options_.stats_file().empty()) {
      write_atomically(options_.stats_file(), statistics_json(run, frame, moved));
    }
    return done;
  }

  // Frames after the first, whose times are reported: in them everything is built.
  [[nodiscard]] int moved_count() const {
    return options_.stats_file().empty() && options_.repeat() == 1 ? 0 : options_.repeat();
  }

  [[nodiscard]] Frame render(SceneRenderer& renderer, const Scene& scene,
                             const RenderRequest& request, int count) const {
    const ProgressLine line("frame " + std::to_string(count) + " of " +
                            std::to_string(1 + moved_count()));
    return finished(renderer.render(scene, request, interruption(), line.progress()));
  }

  [[nodiscard]] std::vector<FrameStatistics> moved_frames(SceneRenderer& renderer,
                                                          const Scene& scene,
                                                          const Frame& frame) const {
    std::vector<FrameStatistics> moved;
    RenderRequest request = *frame.request;
    request.error = ErrorMeasurement::none;
    request.layers = {};
    for (int i = 1; i <= moved_count(); ++i) {
      // Too small a step to change the cost, but nothing of the last view can be reused.
      request.camera = frame.camera;
      request.camera->eye += (1 + i % 1000) * 1e-6 * (frame.camera.target - frame.camera.eye);
      moved.push_back(render(renderer, scene, request, 1 + i).statistics);
    }
    check_interrupted();
    return moved;
  }

  RenderOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_render_command(CLI::App& app) {
  return std::make_unique<RenderCommand>(app);
}

}  // namespace brume
