#include "tools/brume/frame_pattern.h"

#include <algorithm>
#include <numeric>
#include <regex>

#include "core/io/text_scanner.h"
#include "tools/brume/command.h"

namespace brume {
namespace {

const std::regex& number_place() {
  static const std::regex place("%(0?[0-9])?d");
  return place;
}

}  // namespace

bool FramePattern::is_pattern(const std::string& text) {
  return std::regex_search(text, number_place());
}

FramePattern::FramePattern(const std::string& text) {
  std::smatch found;
  if (!std::regex_search(text, found, number_place()) || is_pattern(found.suffix())) {
    throw UsageError("found " + shown(text) +
                     "; allowed for a sequence: a name with one %d or %04d for the frame");
  }
  before_ = found.prefix();
  after_ = found.suffix();
  if (found[1].matched) width_ = static_cast<std::size_t>(std::stoi(found[1]));
}

std::string FramePattern::of(int frame) const {
  const std::string digits = std::to_string(frame);
  const std::string zeros(width_ > digits.size() ? width_ - digits.size() : 0, '0');
  return before_ + zeros + digits + after_;
}

std::vector<int> parse_frames(const std::string& text) {
  constexpr int most = 100'000;
  const std::size_t dash = text.find('-');
  const auto first = parse_integer(text.substr(0, dash));
  const auto last = dash == std::string::npos ? first : parse_integer(text.substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first || *last > 1'000'000'000 ||
      *last - *first >= most) {
    throw UsageError("--frames: found " + shown(text) + "; allowed: FIRST-LAST, at most " +
                     std::to_string(most) + " frames");
  }
  std::vector<int> frames(static_cast<std::size_t>(*last - *first + 1));
  std::iota(frames.begin(), frames.end(), static_cast<int>(*first));
  return frames;
}

}  // namespace brume
