#pragma once

#include <string>
#include <vector>

namespace brume {

// File names of a sequence: one "%d" or "%04d" (any width up to 9) stands for the frame's number.
class FramePattern {
 public:
  // Throws UsageError where `text` has not exactly one.
  explicit FramePattern(const std::string& text);
  [[nodiscard]] std::string of(int frame) const;

  static bool is_pattern(const std::string& text);

 private:
  std::string before_, after_;
  std::size_t width_ = 0;
};

// "11-40" as 11, 12, ..., 40; "7" as 7. Throws UsageError.
std::vector<int> parse_frames(const std::string& text);

}  // namespace brume
