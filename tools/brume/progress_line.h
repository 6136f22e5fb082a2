#pragma once

#include <functional>
#include <string>

#include "render/job.h"

namespace brume {

// Says on the terminal what is being done and how far it is, if somebody watches, and is gone in
// the end.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Takes shares in [0, 1], from any thread; null if nobody watches.
  [[nodiscard]] std::function<void(double)> progress() const;

  // Tells its progress here and listens to Ctrl-C.
  [[nodiscard]] Job job() const;

 private:
  std::string what_;
  bool is_watched_;
};

}  // namespace brume
