#include "core/io/frame_loop.h"

#include <chrono>
#include <future>
#include <new>
#include <optional>

#include "brume/error.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Running {
 public:
  Running(std::span<const int> frames, const FrameLoop::Steps& steps)
      : frames_(frames), steps_(steps) {}

  FrameLoop::Result run() {
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const int frame = frames_[i];
      if (steps_.skips && steps_.skips(frame)) {
        result_.skipped.push_back(frame);
      } else {
        make(frame, label(i));
      }
      if (steps_.progressed) steps_.progressed(i + 1, frames_.size());
    }
    finish_writing();
    return std::move(result_);
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
    if (steps_.failed) steps_.failed(frame, why);
    result_.failed.emplace_back(frame, why);
  }

  void make(int frame, const std::string& label) {
    if (steps_.begins) steps_.begins(frame, label);
    const auto start = Clock::now();
    FrameLoop::Write write;
    bool is_made = false;
    guarded(frame, [&] {
      write = steps_.make(frame, label);
      is_made = true;
    });
    result_.making += seconds_since(start);
    finish_writing();
    if (!is_made) return;
    ++timed_;
    if (write) {
      writing_ = {frame, std::async(std::launch::async, std::move(write))};
    } else {
      result_.made.push_back(frame);
    }
  }

  // Waits until the files of the last frame are written.
  void finish_writing() {
    if (!writing_) return;
    auto [frame, file] = std::move(*writing_);
    writing_.reset();
    const auto start = Clock::now();
    guarded(frame, [&, frame = frame] {
      file.get();
      result_.made.push_back(frame);
    });
    result_.waiting += seconds_since(start);
  }

  [[nodiscard]] std::string label(std::size_t index) const {
    std::string text = "frame " + std::to_string(frames_[index]) + ", " +
                       std::to_string(index + 1) + " of " + std::to_string(frames_.size());
    if (timed_ == 0) return text;
    const double each = (result_.making + result_.waiting) / timed_;
    return text + ", " +
           estimated_seconds_text(each * static_cast<double>(frames_.size() - index)) + " left";
  }

  std::span<const int> frames_;
  const FrameLoop::Steps& steps_;
  FrameLoop::Result result_;
  std::optional<std::pair<int, std::future<void>>> writing_;
  int timed_ = 0;
};

}  // namespace

std::string estimated_seconds_text(double seconds) {
  const auto whole = static_cast<long long>(seconds + 0.5);
  if (whole >= 3600) {
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
  }
  if (whole >= 60) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole) + " s";
}

std::vector<int> FrameLoop::Result::failed_frames() const {
  std::vector<int> frames;
  for (const auto& [frame, why] : failed) frames.push_back(frame);
  return frames;
}

FrameLoop::Result FrameLoop::run(std::span<const int> frames, const Steps& steps) {
  return Running(frames, steps).run();
}

}  // namespace brume
