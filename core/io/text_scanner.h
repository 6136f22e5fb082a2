#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace brume {

// Walks through a text line by line and token by token (separated by white space). Lines end with
// \n or \r\n and are counted from 1.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : rest_(text) {}

  bool next_line();                // false at the end of the text
  std::string_view next_token();   // of this line; empty at its end
  std::string_view token_ahead();  // of this or a following line; empty at the end of the text

  [[nodiscard]] std::string_view rest_of_line() const { return line_; }
  [[nodiscard]] std::size_t line_number() const { return number_; }
  [[nodiscard]] std::string place() const { return "line " + std::to_string(number_); }
  [[nodiscard]] std::string_view rest_of_text() const { return rest_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

// The number that is the whole of `token`, or nothing. NaN and infinity are read as such.
std::optional<double> parse_number(std::string_view token);
std::optional<std::int64_t> parse_integer(std::string_view token);

// A value from a file as an error message shows it: in one piece and not too long.
std::string shown(std::string_view text, std::size_t longest = 60);

}  // namespace brume
