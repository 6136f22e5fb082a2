#include "core/io/frame_pattern.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_digits = 9;

const std::regex& number_place() {
  static const std::regex place("%(0?[0-9])?d");
  return place;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

bool FramePattern::is_pattern(const std::string& text) {
  return std::regex_search(text, number_place());
}

std::optional<FramePattern> FramePattern::parse(const std::string& text) {
  std::smatch found;
  if (!std::regex_search(text, found, number_place()) || is_pattern(found.suffix())) {
    return std::nullopt;
  }
  FramePattern pattern;
  pattern.before_ = found.prefix();
  pattern.place_ = found.str();
  pattern.after_ = found.suffix();
  if (found[1].matched) pattern.width_ = static_cast<std::size_t>(std::stoi(found[1]));
  return pattern;
}

std::optional<FramePattern> FramePattern::around(const std::string& file) {
  const std::size_t name = fs::path(file).parent_path().string().size();
  const std::size_t extension = file.size() - fs::path(file).extension().string().size();
  const auto last =
      std::find_if(file.rbegin() + static_cast<std::ptrdiff_t>(file.size() - extension),
                   file.rend() - static_cast<std::ptrdiff_t>(name), is_digit);
  const auto end = static_cast<std::size_t>(file.rend() - last);
  std::size_t begin = end;
  while (begin > name && end - begin < most_digits && is_digit(file[begin - 1])) --begin;
  if (begin == end) return std::nullopt;
  const std::string width = std::to_string(end - begin);
  const bool is_padded = file[begin] == '0';
  const auto pattern =
      parse(file.substr(0, begin) + (is_padded ? "%0" + width + "d" : "%d") + file.substr(end));
  if (!pattern || pattern->frames().size() < 2) return std::nullopt;
  return pattern;
}

std::string FramePattern::of(int frame) const {
  const std::string digits = std::to_string(frame);
  const std::string zeros(width_ > digits.size() ? width_ - digits.size() : 0, '0');
  return before_ + zeros + digits + after_;
}

std::vector<int> FramePattern::frames() const {
  std::vector<int> found;
  const fs::path folder = fs::path(before_).parent_path();
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
       !error && entry != end; entry.increment(error)) {
    const std::string file = (folder / entry->path().filename()).string();
    if (file.size() <= before_.size() + after_.size() || !file.starts_with(before_)) continue;
    const std::string digits =
        file.substr(before_.size(), file.size() - before_.size() - after_.size());
    if (digits.size() > most_digits || !std::all_of(digits.begin(), digits.end(), is_digit)) {
      continue;
    }
    const auto number = parse_integer(digits);
    if (number && of(static_cast<int>(*number)) == file) {
      found.push_back(static_cast<int>(*number));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace brume
