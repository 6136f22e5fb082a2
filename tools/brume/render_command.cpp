#include <tbb/global_control.h>

#include <chrono>
#include <optional>
#include <sstream>
#include <utility>

#include "brume/at_time.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/atomic_file.h"
#include "render/deep/deep_file.h"
#include "render/gl_renderer.h"
#include "render/layers/frame_layers.h"
#include "render/output/frame_file.h"
#include "render/quality/auto_quality.h"
#include "render/render_plan.h"
#include "render/samples/exposure.h"
#include "render/shot.h"
#include "render/transfer/transfer_cache.h"
#include "render/transfer/transfer_store.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/read_scene.h"
#include "tools/brume/render_options.h"
#include "tools/brume/render_statistics.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

bool is_truth(const Settings& settings) {
  return settings.airlight == AirlightMethod::path ||
         settings.airlight == AirlightMethod::reference;
}

// Radiance transfer of the scene, from the disk cache or computed. Returns the time [ms].
double make_transfers(const Scene& scene, const Settings& settings, TransferStore& transfers) {
  const Clock::time_point start = Clock::now();
  const std::vector<TransferRequest> needed = needed_transfers(scene, settings);
  if (needed.empty()) return 0.0;
  std::vector<std::string> warnings;
  {
    const ProgressLine line("radiance transfer");
    transfers.make(needed, cache_folder(), line.job(), &warnings);
    check_interrupted();
  }
  print_warnings(warnings);
  return Milliseconds(Clock::now() - start).count();
}

void check_layer_memory(const Scene& scene, const Film& film, const OutputLayers& layers) {
  const std::size_t bytes = layer_bytes(scene, film, layers);
  if (bytes <= limits::scene_bytes) return;
  throw UsageError("--layers: they take " + std::to_string(bytes) + " bytes; allowed: at most " +
                   std::to_string(limits::scene_bytes) + "; choose fewer, or a smaller --size");
}

void warn_of_coarse_slices(const DeepFileStatistics& deep) {
  if (deep.image.coarse_tiles == 0) return;
  print_warnings({"--deep-error: " + std::to_string(deep.image.coarse_tiles) +
                  " tiles of 16 x 8 pixels are too steep for this error; more --slices help"});
}

// Reports when gl was requested but did not render.
void warn_of_cpu(std::string problem, const FrameStatistics& statistics) {
  if (statistics.backend == "gl") return;
  if (problem.empty() && !statistics.on_cpu.empty()) problem = statistics.on_cpu.front().why;
  print_warnings({"--backend gl: rendered on the CPU: " + problem});
}

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
    Settings settings = options_.settings();
    // Frames have their own arenas; this also limits everything else.
    const tbb::global_control bound(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(settings.threads));
    const DisplayLook look = options_.display();
    CommandFiles files = options_.outputs();

    const Clock::time_point start = Clock::now();
    const Scene animation = options_.seen_by_camera(read_scene(options_.scene_file(), files));
    const Scene scene = evaluate_at(animation, options_.time());
    const Film film = options_.film(scene);
    check_layer_memory(scene, film, options_.layers());
    const auto transfers = std::make_shared<TransferStore>();
    const bool is_path = settings.airlight == AirlightMethod::path;
    const double transfer_milliseconds =
        is_path ? 0.0 : make_transfers(scene, settings, *transfers);
    std::string problem;
    const std::unique_ptr<FrameRenderer> renderer =
        make_renderer(options_.backend(), transfers, problem);
    const Shot shot{animation, scene, std::nullopt, film, options_.exposure(animation)};

    std::optional<ErrorEstimate> error;
    Frame frame = first_frame(*renderer, shot, settings, error);
    const Milliseconds first = Clock::now() - start;
    if (options_.backend() == Backend::gl) warn_of_cpu(problem, frame.statistics);
    if (error) warn_of_error(*error, options_.max_error());
    const std::vector<FrameStatistics> moved = moved_frames(*renderer, shot, settings);
    const std::optional<DeepFileStatistics> deep =
        write(*renderer, shot, settings, look, frame, *transfers);
    if (options_.stats_file().empty()) return done;

    // What paths say of their error is their noise; the integral is scattered once only.
    if (!error && !is_truth(settings)) {
      const ProgressLine line("measuring the error");
      error = finished(measure_error(scene, scene.camera, frame, interruption(), line.progress()));
    }
    const RenderRun run{options_.scene_file(),
                        film,
                        settings,
                        options_.repeat(),
                        first.count(),
                        transfer_milliseconds,
                        error,
                        relative_noise(frame),
                        deep};
    write_atomically(options_.stats_file(), statistics_json(run, frame.statistics, moved));
    return done;
  }

 private:
  // `settings` become those that rendered it; with auto, `error` is measured.
  [[nodiscard]] Frame first_frame(FrameRenderer& renderer, const Shot& shot, Settings& settings,
                                  std::optional<ErrorEstimate>& error) const {
    const ProgressLine line("frame 1 of " + std::to_string(1 + moved_count()));
    RequestedFrame found = finished(render_shot(renderer, shot, settings, line.job()));
    settings = found.settings;
    error = found.error;
    return std::move(found.frame);
  }

  // Frames after the first, whose times are reported: in them everything is built.
  [[nodiscard]] int moved_count() const {
    return options_.stats_file().empty() && options_.repeat() == 1 ? 0 : options_.repeat();
  }

  [[nodiscard]] std::vector<FrameStatistics> moved_frames(FrameRenderer& renderer, Shot shot,
                                                          const Settings& settings) const {
    std::vector<FrameStatistics> moved;
    for (int i = 1; i <= moved_count(); ++i) {
      // Too small a step to change the cost, but nothing of the last view can be reused.
      Camera& camera = shot.camera.emplace(shot.scene.camera);
      camera.eye += (1 + i % 1000) * 1e-6 * (camera.target - camera.eye);
      const ProgressLine line("frame " + std::to_string(i + 1) + " of " +
                              std::to_string(1 + moved_count()));
      moved.push_back(finished(render_shot(renderer, shot, settings, line.job())).frame.statistics);
    }
    check_interrupted();
    return moved;
  }

  // What there is to say of a deep file.
  [[nodiscard]] std::optional<DeepFileStatistics> write(FrameRenderer& renderer, const Shot& shot,
                                                        const Settings& settings,
                                                        const DisplayLook& look, Frame& frame,
                                                        TransferStore& transfers) const {
    const FrameInfo info{options_.scene_file(), airlight_name(settings), frame.statistics.backend,
                         look, relative_noise(frame)};
    const Camera& camera = shot.scene.camera;
    if (options_.is_deep()) {
      const ProgressLine line("deep frame");
      const DeepFileStatistics deep = finished(write_deep_frame(
          options_.output(), shot.scene, camera, shot.film,
          deep_settings(settings, options_.deep_error(), frame), transfers, info, line.job()));
      warn_of_coarse_slices(deep);
      return deep;
    }
    ImageLayers more;
    if (const OutputLayers layers = options_.layers(); has_more_layers(layers)) {
      const LayeredFrame layered{shot.animation,
                                 shot.scene,
                                 nullptr,
                                 settings,
                                 render_lit_by(renderer, {shot.moments(), options_.time(),
                                                          shot.camera, shot.film, shot.exposure}),
                                 frame};
      const ProgressLine line("layers");
      more = finished(render_layers(layered, layers, line.job()));
    }
    write_frame(options_.output(), frame, info, more);
    return {};
  }

  RenderOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_render_command(CLI::App& app) {
  return std::make_unique<RenderCommand>(app);
}

}  // namespace brume
