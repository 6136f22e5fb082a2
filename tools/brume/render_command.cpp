#include <tbb/global_control.h>

#include <chrono>
#include <optional>
#include <sstream>
#include <utility>

#include "core/io/atomic_file.h"
#include "core/io/image/image_file.h"
#include "render/quality/auto_quality.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/frame_maker.h"
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

void warn_of_error(const ErrorEstimate& error, double max_error) {
  if (error.high <= max_error) return;
  std::ostringstream text;
  text << "no setting is certain to meet --max-error " << max_error
       << "; this one has a relative RMSE of " << error.rel_rmse << ", " << error.low << " to "
       << error.high;
  print_warnings({text.str()});
}

class RenderCommand final : public Command {
 public:
  explicit RenderCommand(CLI::App& app) : options_(app) {}

  ExitCode run() override {
    options_.check();
    // Frames have their own arenas; this also limits everything else.
    const int threads = options_.settings().threads;
    const tbb::global_control bound(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    set_image_threads(threads);
    if (options_.is_sequence()) return render_sequence(options_);
    CommandFiles files = options_.outputs();
    const Clock::time_point start = Clock::now();
    FrameMaker maker(options_, read_scene(options_.scene_file(), files));
    maker.go_to(options_.time());
    RequestedFrame found = maker.render("frame 1 of " + std::to_string(1 + moved_count()));
    const Milliseconds first = Clock::now() - start;
    if (found.error) warn_of_error(*found.error, options_.max_error());
    const std::vector<FrameStatistics> moved = moved_frames(maker, found.settings);
    const ImageLayers layers = maker.complete(found);
    const FrameInfo info = maker.info(found);
    RenderRun run{.scene = options_.scene_file(),
                  .time = maker.scene().time,
                  .film = maker.film(),
                  .settings = found.settings,
                  .repeat = options_.repeat(),
                  .first_frame_milliseconds = first.count(),
                  .transfer_milliseconds = maker.transfer_milliseconds(),
                  .error = found.error,
                  .noise = info.noise};
    if (options_.is_deep()) {
      run.deep = maker.write_deep(options_.output(), found, info);
    } else {
      write_frame(options_.output(), found.frame, info, layers);
    }
    if (!options_.stats_file().empty()) {
      write_atomically(options_.stats_file(), statistics_json(run, found.frame.statistics, moved));
    }
    return done;
  }

 private:
  // Frames after the first, whose times are reported: in them everything is built.
  [[nodiscard]] int moved_count() const {
    return options_.stats_file().empty() && options_.repeat() == 1 ? 0 : options_.repeat();
  }

  [[nodiscard]] std::vector<FrameStatistics> moved_frames(const FrameMaker& maker,
                                                          const Settings& settings) const {
    std::vector<FrameStatistics> moved;
    for (int i = 1; i <= moved_count(); ++i) {
      // Too small a step to change the cost, but nothing of the last view can be reused.
      Camera camera = maker.scene().camera;
      camera.eye += (1 + i % 1000) * 1e-6 * (camera.target - camera.eye);
      const std::string label =
          "frame " + std::to_string(i + 1) + " of " + std::to_string(1 + moved_count());
      moved.push_back(maker.render(label, settings, camera).frame.statistics);
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
