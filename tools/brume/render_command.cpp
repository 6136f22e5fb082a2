#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "brume/at_time.h"
#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/frame_loop.h"
#include "core/io/image/image_file.h"
#include "core/scene/animation/sequence_frames.h"
#include "render/deep/deep_file.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/frame_fingerprint.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/render_options.h"
#include "tools/brume/render_statistics.h"

namespace brume {
namespace {

// A line as an engine of the Open Job Description reads it in the output of a task.
void tell_engine(const RenderOptions& options, const char* what, const std::string& text) {
  if (options.tells_engine()) print_result(std::string("openjd_") + what + ": " + text + "\n");
}

// Writes the deep file of a frame, with a warning where it is not fine enough. Throws InputError,
// Interrupted.
DeepFileStatistics write_deep(SceneRenderer& renderer, const std::filesystem::path& file,
                              const Scene& scene, const Frame& frame, const FrameInfo& info) {
  const ProgressLine line("deep frame");
  DeepFileStatistics deep =
      finished(renderer.write_deep(file, scene, frame, info, interruption(), line.progress()));
  if (deep.image.coarse_tiles > 0) {
    print_warnings({"--deep-error: " + std::to_string(deep.image.coarse_tiles) +
                    " tiles of 16 x 8 pixels are too steep for this error; more --slices help"});
  }
  return deep;
}

class FrameSequence {
 public:
  FrameSequence(const RenderOptions& options, SceneDocument document,
                std::vector<std::filesystem::path> missing, double reading)
      : options_(options),
        reading_(reading),
        outputs_(options.output_pattern()),
        fingerprint_(document, options.what_matters(document.scene)),
        missing_(std::move(missing)),
        scene_(options.adjusted(std::move(document.scene))),
        request_(options.request(scene_.film)),
        info_(options.info()) {
    if (info_.look.view) print_warnings(info_.look.view->warnings());
  }

  ExitCode run() {
    remove_abandoned_files(std::filesystem::absolute(options_.output()).parent_path());
    FrameLoop::Steps steps;
    steps.skips = [this](int frame) {
      check_interrupted();
      return options_.skips_existing() &&
             fingerprint_of(outputs_.file_of(frame)) == fingerprint_.of(frame);
    };
    steps.begins = [this](int, const std::string& label) {
      tell_engine(options_, "status", label);
    };
    steps.make = [this](int frame, const std::string& label) { return make(frame, label); };
    steps.failed = [this](int frame, const std::string& why) {
      const std::string text = "frame " + std::to_string(frame) + ": " + why;
      print_note("error: " + text);
      failures_ += (failures_.empty() ? "" : "; ") + text;
    };
    steps.progressed = [this](std::size_t done, std::size_t of) {
      tell_engine(options_, "progress", std::to_string(100 * done / of));
    };
    const FrameLoop::Result result = FrameLoop::run(options_.frames(), steps);
    for (const auto& [warning, count] : warned_) {
      if (count > 1) print_warnings({"in " + std::to_string(count) + " frames: " + warning});
    }
    if (!options_.stats_file().empty()) {
      write_atomically(options_.stats_file(), sequence_statistics_json(statistics_));
    }
    // The last, since an engine may end a task that tells of a failure.
    if (!failures_.empty()) tell_engine(options_, "fail", failures_);
    nlohmann::ordered_json json{
        {"made", result.made}, {"skipped", result.skipped}, {"failed", result.failed_frames()}};
    json["seconds"] = {
        {"reading", reading_}, {"rendering", result.making}, {"waiting_for_files", result.waiting}};
    print_result(json.dump() + "\n");
    return result.failed.empty() ? done : check_failed;
  }

 private:
  // `auto` chooses once for the whole shot, whichever of its frames this process renders: the
  // finest setting that its first, middle and last frame need. They are those of the scene's
  // timeline, or last as long as something moves.
  void choose_for_shot(double now) {
    if (request_.airlight != AirlightMethod::auto_) return;
    const double rate = brume::frame_rate(scene_);
    const double first = scene_.playback ? scene_.playback->first / rate : 0.0;
    const double last = scene_.playback ? scene_.playback->last / rate : last_moment(scene_);
    std::optional<RenderRequest> finest;
    for (const double time : std::set<double>{first, 0.5 * (first + last), last}) {
      RenderRequest request = request_;
      request.time = time;
      try {
        check_present(time);
        const ProgressLine line("setting");
        request = finished(renderer_.choose(scene_, request, interruption(), line.progress()));
      } catch (const std::exception&) {  // which the frame says, too
        continue;
      }
      if (!finest || request.slices > finest->slices) finest = request;
    }
    if (finest) {
      request_ = *finest;
    } else {  // none of them can be rendered, but this frame perhaps
      RenderRequest request = request_;
      request.time = now;
      check_present(now);
      request_ = finished(renderer_.choose(scene_, request, interruption()));
    }
  }

  FrameLoop::Write make(int number, const std::string& label) {
    if (!has_chosen_) choose_for_shot(number / brume::frame_rate(scene_));
    has_chosen_ = true;
    RenderRequest request = request_;
    request.time = number / brume::frame_rate(scene_);
    check_present(request.time);
    RenderRun run{.scene = options_.scene_file(), .frame = number};
    const auto start = std::chrono::steady_clock::now();
    const auto frame = std::make_shared<const Frame>(render(request, label));
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    run.first_frame_milliseconds = taken.count() - frame->statistics.extra_milliseconds;
    warn(number, frame->warnings);
    FrameInfo info = info_;
    info.fingerprint = fingerprint_.of(number);
    info.frame = number;
    const std::filesystem::path file = outputs_.file_of(number);
    if (options_.is_deep()) run.deep = write_deep(renderer_, file, scene_, *frame, info);
    if (!options_.stats_file().empty()) {
      statistics_.push_back(statistics_json(run, *frame, {&frame->statistics, 1}));
    }
    if (options_.is_deep()) return {};
    return [file, info, frame] { write_frame(file, *frame, info); };
  }

  Frame render(const RenderRequest& request, const std::string& label) {
    const ProgressLine line(label);
    return finished(renderer_.render(scene_, request, interruption(), line.progress()));
  }

  // Each warning at once, but once: what follows a semicolon differs from frame to frame.
  void warn(int number, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
      if (++warned_[warning.substr(0, warning.find(';'))] > 1) continue;
      print_warnings({"frame " + std::to_string(number) + ": " + warning});
    }
  }

  // Throws InputError where a moment needs a frame of a sequence whose file is missing.
  void check_present(double time) const {
    for (const MediumSequence& sequence : scene_.sequences) {
      const FramePattern files = *FramePattern::parse(sequence.file.string());
      for (const int index : frames_at(sequence, time)) {
        const std::filesystem::path file = files.file_of(sequence.first + index);
        if (std::ranges::count(missing_, file) > 0) throw InputError(file, "", "is missing");
      }
    }
  }

  const RenderOptions& options_;
  double reading_;  // [s]
  FramePattern outputs_;
  FrameFingerprint fingerprint_;
  std::vector<std::filesystem::path> missing_;
  Scene scene_;
  RenderRequest request_;  // but for the time
  bool has_chosen_ = false;
  FrameInfo info_;
  SceneRenderer renderer_;
  std::vector<std::string> statistics_;  // of the frames made
  std::string failures_;
  std::map<std::string, int> warned_;  // frames, by warning
};

// Renders the frames of an animation to one file each. Writes one while it renders the next. What
// fails in one frame is said at once and leaves the others alone; check_failed then. A line of JSON
// on standard output says which frames were made, left as they were, and failed.
ExitCode render_sequence(const RenderOptions& options) {
  try {
    CommandFiles files = options.outputs();
    std::vector<std::filesystem::path> missing;
    const auto start = std::chrono::steady_clock::now();
    SceneDocument document = read_document(options.scene_file(), files, &missing);
    const std::chrono::duration<double> reading = std::chrono::steady_clock::now() - start;
    return FrameSequence(options, std::move(document), std::move(missing), reading.count()).run();
  } catch (const InputError& error) {
    tell_engine(options, "fail", error.what());
    throw;
  }
}

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
