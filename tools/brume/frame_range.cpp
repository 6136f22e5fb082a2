#include "tools/brume/frame_range.h"

#include <numeric>

#include "core/io/text_scanner.h"
#include "tools/brume/command.h"

namespace brume {

FramePattern parse_pattern(const std::string& text) {
  if (const auto pattern = FramePattern::parse(text)) return *pattern;
  throw UsageError("found " + quoted_text(text) +
                   "; allowed for a sequence: a name with one %d or %04d for the frame");
}

std::vector<int> parse_frames(const std::string& text) {
  constexpr int max_frames = 100'000;
  const std::size_t dash = text.find('-');
  const auto first = parse_integer(text.substr(0, dash));
  const auto last = dash == std::string::npos ? first : parse_integer(text.substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first || *last > 1'000'000'000 ||
      *last - *first >= max_frames) {
    throw UsageError("--frames: found " + quoted_text(text) + "; allowed: FIRST-LAST, at most " +
                     std::to_string(max_frames) + " frames");
  }
  std::vector<int> frames(static_cast<std::size_t>(*last - *first + 1));
  std::iota(frames.begin(), frames.end(), static_cast<int>(*first));
  return frames;
}

}  // namespace brume
