#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brume {

// A table as text, as spreadsheets, R and other programs write it: UTF-8, or UTF-16 with a byte
// order mark; cells between commas, semicolons, tabs or blanks, whichever the heading has, or what
// a first line `sep=;` says; cells in quotes, which may hold separators, line ends and doubled
// quotes; lines of comment, which begin with #, and empty ones. Where no commas separate cells, a
// number may have one as its decimal sign.
class CsvTable {
 public:
  // `bytes` of `file`. Throws InputError if they are no text, with what is `allowed` instead.
  CsvTable(std::filesystem::path file, std::string bytes, const char* allowed);
  CsvTable(const CsvTable&) = delete;  // which has views into itself
  CsvTable& operator=(const CsvTable&) = delete;

  // Reads the heading: the first line that is no comment, or a comment of which `is_heading` holds.
  // False: there is none.
  bool read_heading(const std::function<bool()>& is_heading);
  // The heading as it stands in the file.
  [[nodiscard]] std::string_view heading() const { return heading_; }
  // The column of a name, in capitals or not.
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;

  // The next row that has any cell; false at the end. A heading that is one cell shorter than the
  // first row lacks the one of the rows' names, as R writes it. Throws InputError for a row with
  // more cells.
  bool next_row();
  // Nothing where the row ends before.
  [[nodiscard]] std::optional<std::string_view> cell(std::size_t column) const;
  // A cell as a number; nullopt if it is none. Throws InputError for decimal commas in a file with
  // decimal points, where they may separate thousands.
  std::optional<double> number(std::string_view cell);

  // "line 3"
  [[nodiscard]] std::string place() const { return "line " + std::to_string(line_); }

 private:
  bool read_cells();
  std::string_view read_cell();
  std::optional<std::string_view> read_quoted();
  void end_line();
  void skip_blanks();
  void skip_line();
  [[nodiscard]] std::string_view line_ahead() const;

  std::filesystem::path file_;
  std::string text_;
  std::string_view rest_;
  std::size_t line_ = 0;       // where the cells begin
  std::size_t next_line_ = 1;  // where the rest begins
  char separator_ = '\0';      // '\0': as the heading has it
  std::string_view heading_;
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;
  std::optional<std::size_t> row_names_;  // 1 if the heading lacks their cell; nullopt: no row yet
  char decimal_sign_ = '\0';
};

}  // namespace brume
