#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brume {

// File names of a sequence: one "%d" or "%04d" (any width up to 9) stands for the frame's number.
class FramePattern {
 public:
  // nullopt where `text` has not exactly one.
  static std::optional<FramePattern> parse(const std::string& text);
  // That of the files that `file` is one of: the last digits of its name are the frame's number.
  // nullopt where there are none, or no other such file.
  static std::optional<FramePattern> around(const std::string& file);

  [[nodiscard]] std::string text() const { return before_ + place_ + after_; }
  [[nodiscard]] std::string of(int frame) const;  // >= 0
  // The numbers of the files that are there, ascending.
  [[nodiscard]] std::vector<int> frames() const;

  // Whether there is such a place at all.
  static bool is_pattern(const std::string& text);

 private:
  std::string before_, place_, after_;
  std::size_t width_ = 0;
};

}  // namespace brume
