#include "core/io/text_scanner.h"

#include <algorithm>
#include <charconv>

namespace brume {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

template <typename Number>
std::optional<Number> parse(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  Number value{};
  const char* end = token.data() + token.size();
  const auto [stopped, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

}  // namespace

TextScanner::TextScanner(std::string_view text, bool joins_lines)
    : rest_(text), joins_lines_(joins_lines) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool TextScanner::next_line() {
  while (goes_on_) read_line();
  return read_line();
}

bool TextScanner::read_line() {
  goes_on_ = false;
  line_ = {};
  if (rest_.empty()) return false;
  const auto* const end =
      std::find_if(rest_.begin(), rest_.end(), [](char c) { return c == '\n' || c == '\r'; });
  line_ = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(line_.size());
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
  ++number_;
  goes_on_ = joins_lines_ && line_.ends_with('\\') && !line_.starts_with('#');
  if (goes_on_) line_.remove_suffix(1);
  return true;
}

std::string_view TextScanner::next_token() {
  std::size_t begin = line_.find_first_not_of(blanks);
  while (begin == std::string_view::npos) {
    line_ = {};
    if (!goes_on_ || !read_line()) return {};
    begin = line_.find_first_not_of(blanks);
  }
  line_.remove_prefix(begin);
  const std::string_view token = line_.substr(0, line_.find_first_of(blanks));
  line_.remove_prefix(token.size());
  return token;
}

std::string_view TextScanner::token_ahead() {
  for (;;) {
    const std::string_view token = next_token();
    if (!token.empty() || !next_line()) return token;
  }
}

std::optional<double> parse_number(std::string_view token) {
  return parse<double>(token);
}
std::optional<std::int64_t> parse_integer(std::string_view token) {
  return parse<std::int64_t>(token);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t place = text.find(from); place != std::string::npos;
       place = text.find(from, place + to.size())) {
    text.replace(place, from.size(), to);
  }
  return text;
}

std::string quoted_text(std::string_view text, std::size_t longest) {
  if (text.empty()) return "nothing";
  if (text.size() <= longest) return std::string(text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // whole UTF-8
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace brume
