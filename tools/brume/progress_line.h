#pragma once

#include <functional>
#include <string>

namespace brume {

// Says on the terminal how far something is, if somebody watches, and is gone in the end.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Takes shares in [0, 1]; null if nobody watches.
  [[nodiscard]] std::function<void(double)> progress() const;

 private:
  std::string what_;
  bool is_watched_;
};

}  // namespace brume
