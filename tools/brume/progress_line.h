#pragma once

#include <functional>
#include <string>

#include "render/util/job.h"

namespace brume {

// A progress line on the terminal, if interactive; erased at the end.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& label);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Callback for the completed fraction, thread-safe; null if not interactive.
  [[nodiscard]] std::function<void(double)> progress() const;

  // A job that reports progress here and stops on Ctrl-C.
  [[nodiscard]] Job job() const;

 private:
  std::string label_;
  bool is_watched_;
};

}  // namespace brume
