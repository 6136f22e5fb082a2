#include "core/io/frame_pattern.h"

#include <algorithm>
#include <filesystem>

#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t max_digits = 9;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

struct NumberPlace {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::size_t begin_of_name(const std::string& file) {
  return file.size() - fs::path(file).filename().string().size();
}

// The first of %d, %4d or %04d that begins at `first` or later; %% is a percent.
std::optional<NumberPlace> find_number_place(const std::string& text, std::size_t first) {
  for (std::size_t begin = text.find('%', first); begin != std::string::npos;
       begin = text.find('%', begin + 1)) {
    std::size_t end = begin + 1;
    if (text[end] == '%') {
      begin = end;
      continue;
    }
    if (text[end] == '0') ++end;
    if (is_digit(text[end])) ++end;
    if (text[end] == 'd') return NumberPlace{begin, end + 1};
  }
  return std::nullopt;
}

}  // namespace

bool FramePattern::is_pattern(const std::string& text) {
  return find_number_place(text, begin_of_name(text)).has_value();
}

std::optional<FramePattern> FramePattern::parse(const std::string& text) {
  const std::size_t name = begin_of_name(text);
  const auto place = find_number_place(text, name);
  if (!place || find_number_place(text, place->end)) return std::nullopt;
  FramePattern pattern;
  pattern.text_ = text;
  pattern.before_ =
      text.substr(0, name) + replaced(text.substr(name, place->begin - name), "%%", "%");
  pattern.place_ = text.substr(place->begin, place->end - place->begin);
  pattern.after_ = replaced(text.substr(place->end), "%%", "%");
  const std::string width = pattern.place_.substr(1, pattern.place_.size() - 2);
  if (!width.empty()) pattern.width_ = static_cast<std::size_t>(std::stoi(width));
  return pattern;
}

std::string FramePattern::printf_text() const {
  return replaced(before_, "%", "%%") + place_ + replaced(after_, "%", "%%");
}

std::optional<FramePattern> FramePattern::around(const std::string& file) {
  const std::size_t name = begin_of_name(file);
  const std::size_t extension = file.size() - fs::path(file).extension().string().size();
  const auto last =
      std::find_if(file.rbegin() + static_cast<std::ptrdiff_t>(file.size() - extension),
                   file.rend() - static_cast<std::ptrdiff_t>(name), is_digit);
  const auto end = static_cast<std::size_t>(file.rend() - last);
  std::size_t begin = end;
  while (begin > name && end - begin < max_digits && is_digit(file[begin - 1])) --begin;
  if (begin == end) return std::nullopt;
  const std::string width = std::to_string(end - begin);
  const bool is_padded = file[begin] == '0';
  auto pattern =
      parse(file.substr(0, name) + replaced(file.substr(name, begin - name), "%", "%%") +
            (is_padded ? "%0" + width + "d" : "%d") + replaced(file.substr(end), "%", "%%"));
  if (!pattern || pattern->frames().size() < 2) return std::nullopt;
  return pattern;
}

std::string FramePattern::file_of(int frame) const {
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
    if (digits.size() > max_digits || !std::all_of(digits.begin(), digits.end(), is_digit)) {
      continue;
    }
    const auto number = parse_integer(digits);
    if (number && file_of(static_cast<int>(*number)) == file) {
      found.push_back(static_cast<int>(*number));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace brume
