#include "tools/brume/progress_line.h"

#include <unistd.h>

#include <atomic>
#include <iostream>
#include <memory>

#include "core/io/text_scanner.h"
#include "core/printable_text.h"
#include "tools/brume/interruption.h"

namespace brume {

ProgressLine::ProgressLine(const std::string& label)
    : label_(printable(quoted_text(label))), is_watched_(::isatty(STDERR_FILENO) != 0) {
  if (is_watched_) std::cerr << '\r' + label_ + " ...\033[K" << std::flush;
}

ProgressLine::~ProgressLine() {
  if (is_watched_) std::cerr << "\r\033[K" << std::flush;
}

std::function<void(double)> ProgressLine::progress() const {
  if (!is_watched_) return {};
  return [label = label_, shown = std::make_shared<std::atomic<int>>(-1)](double fraction) {
    const int percent = static_cast<int>(100.0 * fraction);
    if (shown->exchange(percent) == percent) return;
    std::cerr << '\r' + label + ": " + std::to_string(percent) + "%\033[K" << std::flush;
  };
}

Job ProgressLine::job() const {
  return {interruption(), progress()};
}

}  // namespace brume
