#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace brume {

// Scans a text by lines and white-space-separated tokens. Lines end with \n, \r\n or \r and are
// counted from 1. A byte order mark before the first is no part of it.
class TextScanner {
 public:
  // With `joins_lines` a line that is no comment (#) and ends with a backslash goes on in the next.
  explicit TextScanner(std::string_view text, bool joins_lines = false);

  bool next_line();                // false at the end of the text
  std::string_view next_token();   // of this line; empty at its end
  std::string_view token_ahead();  // of this or a later line; empty at the end of the text
  void skip_line() { line_ = {}; }

  [[nodiscard]] std::string_view rest_of_line() const { return line_; }
  [[nodiscard]] std::string place() const { return "line " + std::to_string(number_); }
  [[nodiscard]] std::string_view rest_of_text() const { return rest_; }

 private:
  bool read_line();

  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
  bool joins_lines_;
  bool goes_on_ = false;  // line_, in the next
};

// Parses the whole token as a number; nullopt otherwise. Accepts NaN and infinity.
std::optional<double> parse_number(std::string_view token);
std::optional<std::int64_t> parse_integer(std::string_view token);

// Input text as quoted in error messages: printable and truncated.
std::string quoted_text(std::string_view text, std::size_t longest = 60);

// The text with `to` in the place of each `from`.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace brume
