#include "tools/brume/progress_line.h"

#include <unistd.h>

#include <atomic>
#include <iostream>
#include <memory>
#include <utility>

#include "core/io/text_scanner.h"
#include "core/printable_text.h"
#include "tools/brume/interruption.h"

namespace brume {

ProgressLine::ProgressLine(const std::string& what)
    : what_(printable(quoted_text(what))), is_watched_(::isatty(STDERR_FILENO) != 0) {
  if (is_watched_) std::cerr << '\r' + what_ + " ...\033[K" << std::flush;
}

ProgressLine::~ProgressLine() {
  if (is_watched_) std::cerr << "\r\033[K" << std::flush;
}

std::function<void(double)> ProgressLine::progress() const {
  if (!is_watched_) return {};
  return [what = what_, shown = std::make_shared<std::atomic<int>>(-1)](double share) {
    const int percent = static_cast<int>(100.0 * share);
    if (shown->exchange(percent) == percent) return;
    std::cerr << '\r' + what + ": " + std::to_string(percent) + "%\033[K" << std::flush;
  };
}

Job ProgressLine::job() const {
  return {interruption(), progress()};
}

}  // namespace brume
