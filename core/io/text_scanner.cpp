#include "core/io/text_scanner.h"

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

bool TextScanner::next_line() {
  if (rest_.empty()) {
    line_ = {};
    return false;
  }
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view TextScanner::next_token() {
  const std::size_t begin = line_.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    line_ = {};
    return {};
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

std::string quoted_text(std::string_view text, std::size_t longest) {
  if (text.empty()) return "nothing";
  if (text.size() <= longest) return std::string(text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // whole UTF-8
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace brume
