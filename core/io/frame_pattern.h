#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brume {

// File names of a sequence: one "%d" or "%04d" (width up to 9) is replaced by the frame number.
class FramePattern {
 public:
  // nullopt unless `text` has exactly one placeholder.
  static std::optional<FramePattern> parse(const std::string& text);
  // The pattern that `file` belongs to: the last digits of its name are the frame number. nullopt
  // if there are none or no other such file.
  static std::optional<FramePattern> around(const std::string& file);

  [[nodiscard]] std::string text() const { return before_ + place_ + after_; }
  [[nodiscard]] std::string file_of(int frame) const;  // >= 0
  // Numbers of existing files, ascending.
  [[nodiscard]] std::vector<int> frames() const;

  // Whether the text has a placeholder.
  static bool is_pattern(const std::string& text);

 private:
  std::string before_, place_, after_;
  std::size_t width_ = 0;
};

}  // namespace brume
