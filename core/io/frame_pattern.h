#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brume {

// File names of a sequence: one "%d" or "%04d" (width up to 9) is replaced by the frame number,
// "%%" is a percent. Both count in the file's name only, not in its folder.
class FramePattern {
 public:
  // nullopt unless `text` has exactly one placeholder.
  static std::optional<FramePattern> parse(const std::string& text);
  // The pattern that `file` belongs to: the last digits of its name are the frame number. nullopt
  // if there are none or no other such file.
  static std::optional<FramePattern> around(const std::string& file);

  [[nodiscard]] const std::string& text() const { return text_; }
  // The same as printf() reads it, folder and all.
  [[nodiscard]] std::string printf_text() const;
  [[nodiscard]] std::string file_without_number() const { return before_ + after_; }
  [[nodiscard]] std::string file_of(int frame) const;  // >= 0
  // Numbers of existing files, ascending.
  [[nodiscard]] std::vector<int> frames() const;

  // Whether the text has a placeholder.
  static bool is_pattern(const std::string& text);

 private:
  std::string text_, place_;
  std::string before_, after_;  // of files
  std::size_t width_ = 0;
};

}  // namespace brume
