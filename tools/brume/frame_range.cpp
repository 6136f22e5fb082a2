#include "tools/brume/frame_range.h"

#include <cstdint>
#include <set>
#include <string_view>

#include "core/io/text_scanner.h"
#include "tools/brume/command.h"
#include "tools/brume/request_arguments.h"

namespace brume {

FramePattern parse_pattern(const std::string& text) {
  if (const auto pattern = FramePattern::parse(text)) return *pattern;
  throw UsageError("found " + quoted_text(text) +
                   "; allowed for a sequence: a name with one %d or %04d for the frame");
}

void add_frame_rate(CLI::App& app, std::optional<double>& rate) {
  app.add_option("--fps", rate,
                 "frames per second: frame n is at n / fps seconds; default: those of the scene's "
                 "timeline, else 30")
      ->check(finite_in(1e-3, 1e6));
}

namespace {

constexpr std::size_t max_frames = 100'000;
constexpr std::int64_t max_number = 1'000'000'000;

// "A", "A-B", "A-BxN", or "A-B:N" as the Open Job Description has it.
struct FrameRange {
  std::int64_t first, last, step;
};
std::optional<FrameRange> parse_range(std::string_view text) {
  const std::size_t dash = text.find('-');
  const std::size_t cross = dash == std::string_view::npos ? dash : text.find_first_of("x:", dash);
  const auto first = parse_integer(text.substr(0, dash));
  const auto last = dash == std::string_view::npos
                        ? first
                        : parse_integer(text.substr(dash + 1, cross - dash - 1));
  const auto step = cross == std::string_view::npos ? std::optional(std::int64_t{1})
                                                    : parse_integer(text.substr(cross + 1));
  if (!first || !last || !step || *first < 0 || *last < *first || *last > max_number || *step < 1 ||
      *step > max_number) {
    return std::nullopt;
  }
  return FrameRange{*first, *last, *step};
}

}  // namespace

std::vector<int> parse_frames(const std::string& text) {
  std::vector<int> frames;
  std::set<std::int64_t> known;
  const auto refuse = [&text] {
    throw UsageError("--frames: found " + quoted_text(text) +
                     "; allowed: FIRST-LAST, FIRST-LASTxSTEP or FRAME, several with commas between "
                     "them, at most " +
                     std::to_string(max_frames) + " frames");
  };
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::optional<FrameRange> range = parse_range(rest.substr(0, comma));
    if (!range) refuse();
    for (std::int64_t frame = range->first; frame <= range->last; frame += range->step) {
      if (known.insert(frame).second) frames.push_back(static_cast<int>(frame));
      if (frames.size() > max_frames) refuse();
    }
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
  return frames;
}

}  // namespace brume
