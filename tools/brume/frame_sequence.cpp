#include "tools/brume/frame_sequence.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <future>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "core/io/atomic_file.h"
#include "core/scene/sequence_frames.h"
#include "tools/brume/frame_fingerprint.h"
#include "tools/brume/frame_maker.h"
#include "tools/brume/interruption.h"
#include "tools/brume/read_scene.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// "1 h 2 min", "3 min 4 s", "5 s"
std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(seconds + 0.5);
  if (whole >= 3600) {
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
  }
  if (whole >= 60) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole) + " s";
}

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
        fingerprint_(document, options.what_matters()),
        missing_(std::move(missing)),
        sequences_(document.scene.sequences),
        maker_(options, options.seen_by_camera(std::move(document.scene))) {}

  ExitCode run() {
    const std::vector<int> frames = options_.frames();
    remove_abandoned_files(std::filesystem::absolute(options_.output()).parent_path());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      check_interrupted();
      const int frame = frames[i];
      const std::string fingerprint = fingerprint_.of(frame);
      if (options_.skips_existing() && fingerprint_of(outputs_.file_of(frame)) == fingerprint) {
        skipped_.push_back(frame);
      } else {
        const std::string text = label(frame, i, frames.size());
        tell_engine(options_, "status", text);
        guarded(frame, [&] { make(frame, text, fingerprint); });
      }
      tell_engine(options_, "progress", std::to_string(100 * (i + 1) / frames.size()));
    }
    finish_writing();
    if (unsure_ > 0) {
      print_warnings(
          {"in " + std::to_string(unsure_) + " frames no setting is certain to meet --max-error"});
    }
    // The last, since an engine may end a task that tells of a failure.
    if (!failures_.empty()) tell_engine(options_, "fail", failures_);
    nlohmann::ordered_json result{{"made", made_}, {"skipped", skipped_}, {"failed", failed_}};
    result["seconds"] = {
        {"reading", reading_}, {"rendering", rendering_}, {"waiting_for_files", waiting_}};
    print_result(result.dump() + "\n");
    return failed_.empty() ? done : check_failed;
  }

 private:
  template <class Work>
  void guarded(int frame, Work work) {
    try {
      work();
    } catch (const InputError& error) {
      fail(frame, error.what());
    } catch (const std::bad_alloc&) {
      fail(frame, "not enough memory");
    }
  }

  void fail(int frame, const std::string& why) {
    const std::string text = "frame " + std::to_string(frame) + ": " + why;
    print_note("error: " + text);
    failures_ += (failures_.empty() ? "" : "; ") + text;
    failed_.push_back(frame);
  }

  void make(int frame, const std::string& label, const std::string& fingerprint) {
    const double time = frame / options_.frames_per_second();
    check_present(time);
    const auto start = Clock::now();
    const double waited = waiting_;
    maker_.go_to(time);
    RequestedFrame found = maker_.render(label);
    if (found.error && found.error->high > options_.max_error()) ++unsure_;
    const std::filesystem::path file = outputs_.file_of(frame);
    if (options_.is_deep()) {
      maker_.write_deep(file, found, fingerprint);
      made_.push_back(frame);
    } else {
      FrameMaker::Content content = maker_.content(std::move(found), fingerprint);
      finish_writing();
      writing_ = {frame, std::async(std::launch::async, [file, content = std::move(content)] {
                    write_frame(file, content.frame, content.info, content.layers);
                  })};
    }
    rendering_ += seconds_since(start) - (waiting_ - waited);
    ++timed_;
  }

  // Waits until the last frame is written.
  void finish_writing() {
    if (!writing_) return;
    auto [frame, file] = std::move(*writing_);
    writing_.reset();
    const auto start = Clock::now();
    guarded(frame, [&, frame = frame] {
      file.get();
      made_.push_back(frame);
    });
    waiting_ += seconds_since(start);
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

  [[nodiscard]] std::string label(int frame, std::size_t index, std::size_t count) const {
    std::string text = "frame " + std::to_string(frame) + ", " + std::to_string(index + 1) +
                       " of " + std::to_string(count);
    if (timed_ > 0) {
      text += ", " +
              duration_text((rendering_ + waiting_) / timed_ * static_cast<double>(count - index)) +
              " left";
    }
    return text;
  }

  const RenderOptions& options_;
  double reading_;  // [s], as below
  FramePattern outputs_;
  FrameFingerprint fingerprint_;
  std::vector<std::filesystem::path> missing_;
  std::vector<MediumSequence> sequences_;
  FrameMaker maker_;
  std::optional<std::pair<int, std::future<void>>> writing_;
  std::vector<int> made_, skipped_, failed_;
  std::string failures_;
  int unsure_ = 0;
  double rendering_ = 0.0;
  double waiting_ = 0.0;  // for the file of the frame before
  int timed_ = 0;
};

}  // namespace

ExitCode render_sequence(const RenderOptions& options) {
  try {
    CommandFiles files = options.outputs();
    std::vector<std::filesystem::path> missing;
    const auto start = Clock::now();
    SceneDocument document = read_document(options.scene_file(), files, missing);
    return FrameSequence(options, std::move(document), std::move(missing), seconds_since(start))
        .run();
  } catch (const InputError& error) {
    tell_engine(options, "fail", error.what());
    throw;
  }
}

}  // namespace brume
