#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace brume {

// An estimated time: "1 h 2 min", "3 min 4 s", "5 s".
std::string estimated_seconds_text(double seconds);

// Makes the frames of a sequence one after another, and writes the files of one while the next is
// made. What fails in a frame, by InputError or for want of memory, leaves the others alone; other
// exceptions end the run when the files before are written.
class FrameLoop {
 public:
  // Writes the files of a frame; empty: they are written already.
  using Write = std::function<void()>;
  // `label` says which frame of how many it is, and the time left.
  using Make = std::function<Write(int frame, const std::string& label)>;
  struct Steps {
    Make make;
    std::function<bool(int frame)> skips{};                              // empty: none
    std::function<void(int frame, const std::string& label)> begins{};   // a frame not skipped
    std::function<void(int frame, const std::string& why)> failed{};     // at once
    std::function<void(std::size_t done, std::size_t of)> progressed{};  // after each frame
  };
  struct Result {
    std::vector<int> made, skipped;
    std::vector<std::pair<int, std::string>> failed;  // and why
    double making = 0.0;                              // [s]
    double waiting = 0.0;                             // for files of the frame before [s]

    [[nodiscard]] std::vector<int> failed_frames() const;
  };

  static Result run(std::span<const int> frames, const Steps& steps);
};

}  // namespace brume
