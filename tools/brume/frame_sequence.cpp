#include "tools/brume/frame_sequence.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "core/io/atomic_file.h"
#include "core/io/frame_loop.h"
#include "core/scene/sequence_frames.h"
#include "tools/brume/frame_fingerprint.h"
#include "tools/brume/frame_maker.h"
#include "tools/brume/interruption.h"
#include "tools/brume/read_scene.h"
#include "tools/brume/render_statistics.h"

namespace brume {
namespace {

// A line as an engine of the Open Job Description reads it in the output of a task.
void tell_engine(const RenderOptions& options, const char* what, const std::string& text) {
  if (options.tells_engine()) print_result(std::string("openjd_") + what + ": " + text + "\n");
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
        sequences_(document.scene.sequences),
        maker_(options, std::move(document.scene)) {}

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
    if (unsure_ > 0) {
      print_warnings(
          {"in " + std::to_string(unsure_) + " frames no setting is certain to meet --max-error"});
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
  FrameLoop::Write make(int frame, const std::string& label) {
    const double time = frame / maker_.frames_per_second();
    check_present(time);
    const auto start = std::chrono::steady_clock::now();
    const double transfers = maker_.transfer_milliseconds();
    maker_.go_to(time);
    RequestedFrame found = maker_.render(label);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    if (found.error && found.error->high > options_.max_error()) ++unsure_;
    const std::filesystem::path file = outputs_.file_of(frame);
    ImageLayers layers = maker_.complete(found);
    FrameInfo info = maker_.info(found);
    info.fingerprint = fingerprint_.of(frame);
    info.frame = frame;
    RenderRun run{.scene = options_.scene_file(),
                  .frame = frame,
                  .time = time,
                  .film = maker_.film(),
                  .settings = found.settings,
                  .first_frame_milliseconds = taken.count(),
                  .transfer_milliseconds = maker_.transfer_milliseconds() - transfers,
                  .error = found.error,
                  .noise = info.noise};
    if (options_.is_deep()) run.deep = maker_.write_deep(file, found, info);
    const FrameStatistics& statistics = found.frame.statistics;
    if (!options_.stats_file().empty()) {
      statistics_.push_back(statistics_json(run, statistics, {&statistics, 1}));
    }
    if (options_.is_deep()) return {};
    const auto content =
        std::make_shared<std::pair<Frame, ImageLayers>>(std::move(found.frame), std::move(layers));
    return [file, info, content] { write_frame(file, content->first, info, content->second); };
  }

  // Throws InputError where a moment needs a frame of a sequence whose file is missing.
  void check_present(double time) const {
    for (const MediumSequence& sequence : sequences_) {
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
  std::vector<MediumSequence> sequences_;
  FrameMaker maker_;
  std::vector<std::string> statistics_;  // of the frames made
  std::string failures_;
  int unsure_ = 0;
};

}  // namespace

ExitCode render_sequence(const RenderOptions& options) {
  try {
    CommandFiles files = options.outputs();
    std::vector<std::filesystem::path> missing;
    const auto start = std::chrono::steady_clock::now();
    SceneDocument document = read_document(options.scene_file(), files, missing);
    const std::chrono::duration<double> reading = std::chrono::steady_clock::now() - start;
    return FrameSequence(options, std::move(document), std::move(missing), reading.count()).run();
  } catch (const InputError& error) {
    tell_engine(options, "fail", error.what());
    throw;
  }
}

}  // namespace brume
