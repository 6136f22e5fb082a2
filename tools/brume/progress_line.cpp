#include "tools/brume/progress_line.h"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace brume {

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), is_watched_(::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (is_watched_) std::cerr << "\r\033[K" << std::flush;
}

std::function<void(double)> ProgressLine::progress() const {
  if (!is_watched_) return {};
  return [what = what_, shown = -1](double share) mutable {
    const int percent = static_cast<int>(100.0 * share);
    if (percent == std::exchange(shown, percent)) return;
    std::cerr << '\r' << what << ": " << percent << "%\033[K" << std::flush;
  };
}

}  // namespace brume
