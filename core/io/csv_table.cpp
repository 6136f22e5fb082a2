#include "core/io/csv_table.h"

#include <algorithm>
#include <utility>

#include "brume/error.h"
#include "core/io/text_scanner.h"
#include "core/io/unicode_text.h"

namespace brume {
namespace {

constexpr std::string_view line_ends = "\r\n";

std::string in_lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

// The separator that is most frequent in a heading outside of quotes; a blank if there is none.
char separator_of(std::string_view heading) {
  char best = ' ';
  std::ptrdiff_t max_count = 0;
  for (const char separator : {',', ';', '\t'}) {
    bool is_quoted = false;
    const auto count = std::ranges::count_if(heading, [&](char c) {
      is_quoted = is_quoted != (c == '"');
      return c == separator && !is_quoted;
    });
    if (count <= max_count) continue;
    max_count = count;
    best = separator;
  }
  return best;
}

// The separator of a line such as sep=; as spreadsheets understand it.
std::optional<char> declared_separator(std::string_view line) {
  if (line.size() > 2 && line.front() == '"' && line.back() == '"') {
    line = line.substr(1, line.size() - 2);
  }
  if (line.size() != 5 || in_lower_case(line.substr(0, 4)) != "sep=") return std::nullopt;
  return line.back();
}

}  // namespace

CsvTable::CsvTable(std::filesystem::path file, std::string bytes, const char* allowed)
    : file_(std::move(file)), text_(as_utf8(std::move(bytes))), rest_(text_) {
  if (text_.find('\0') != std::string::npos) {
    throw InputError(file_, "", std::string("is no text; allowed: ") + allowed);
  }
}

std::string_view CsvTable::line_ahead() const {
  return rest_.substr(0, rest_.find_first_of(line_ends));
}

void CsvTable::end_line() {
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
  ++next_line_;
}

void CsvTable::skip_line() {
  rest_.remove_prefix(line_ahead().size());
  end_line();
}

void CsvTable::skip_blanks() {
  const auto is_blank = [this](char c) { return c == ' ' || (c == '\t' && separator_ != '\t'); };
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}

bool CsvTable::read_heading(const std::function<bool()>& is_heading) {
  if (const auto declared = declared_separator(line_ahead())) {
    separator_ = *declared;
    skip_line();
  }
  const char declared = separator_;
  while (!rest_.empty()) {
    skip_blanks();
    const bool is_comment = rest_.starts_with('#');
    if (is_comment) rest_.remove_prefix(1);
    heading_ = line_ahead();
    separator_ = declared != '\0' ? declared : separator_of(heading_);
    const std::string_view following = rest_.substr(heading_.size());
    if (is_comment) rest_ = heading_;  // where no quote reaches beyond the line
    read_cells();
    if (is_comment) {
      rest_ = following;
      --next_line_;
      end_line();
    }
    names_.clear();
    for (const std::string_view name : cells_) names_.push_back(in_lower_case(name));
    while (!names_.empty() && names_.back().empty()) names_.pop_back();
    if (is_comment ? is_heading() : !names_.empty()) return true;
  }
  return false;
}

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

bool CsvTable::next_row() {
  for (;;) {
    if (!read_cells()) return false;
    while (!cells_.empty() && cells_.back().empty()) cells_.pop_back();
    if (cells_.empty()) continue;
    if (!row_names_) row_names_ = cells_.size() == names_.size() + 1 ? 1 : 0;
    const std::size_t allowed = names_.size() + *row_names_;
    if (cells_.size() <= allowed) return true;
    throw InputError(file_, place(),
                     "found " + std::to_string(cells_.size()) + " cells; allowed: " +
                         std::to_string(allowed) + ", as the heading and the first row have");
  }
}

std::optional<std::string_view> CsvTable::cell(std::size_t column) const {
  const std::size_t place = column + row_names_.value_or(0);
  return place < cells_.size() ? std::optional(cells_[place]) : std::nullopt;
}

std::optional<double> CsvTable::number(std::string_view cell) {
  const bool may_have_comma = separator_ != ',';
  const std::size_t sign = cell.find_first_of(may_have_comma ? ".," : ".");
  if (sign == std::string_view::npos) return parse_number(cell);
  std::string text(cell);
  text[sign] = '.';
  const std::optional<double> value = parse_number(text);
  if (!value) return std::nullopt;
  if (decimal_sign_ == '\0') decimal_sign_ = cell[sign];
  if (decimal_sign_ == cell[sign]) return value;
  throw InputError(file_, place(),
                   "found " + quoted_text(cell) + " below a decimal " +
                       (decimal_sign_ == ',' ? "comma" : "point") +
                       "; allowed: one decimal sign in a file");
}

// Comments are skipped. False at the end of the text.
bool CsvTable::read_cells() {
  cells_.clear();
  skip_blanks();
  while (rest_.starts_with('#')) {
    skip_line();
    skip_blanks();
  }
  line_ = next_line_;
  if (rest_.empty()) return false;
  for (;;) {
    skip_blanks();
    const bool is_end = rest_.empty() || line_ends.find(rest_.front()) != std::string_view::npos;
    if (is_end && separator_ == ' ' && !cells_.empty()) break;  // these blanks separate nothing
    cells_.push_back(read_cell());
    if (!rest_.starts_with(separator_)) break;
    rest_.remove_prefix(1);
  }
  end_line();
  return true;
}

std::string_view CsvTable::read_cell() {
  const char* const begin = rest_.data();
  const auto quoted = read_quoted();
  const char ends[] = {separator_, '\r', '\n', '\0'};
  const std::string_view plain = rest_.substr(0, rest_.find_first_of(ends));
  rest_.remove_prefix(plain.size());
  const std::size_t size = plain.find_last_not_of(" \t") + 1;
  if (quoted && size == 0) return *quoted;
  return {begin, static_cast<std::size_t>(plain.data() - begin) + size};
}

// The text in quotes, if they begin here and are closed. A doubled quote within stays doubled:
// no number has one, and no name of a column that is sought.
std::optional<std::string_view> CsvTable::read_quoted() {
  if (!rest_.starts_with('"')) return std::nullopt;
  std::size_t end = rest_.find('"', 1);
  while (end != std::string_view::npos && rest_.substr(end + 1).starts_with('"')) {
    end = rest_.find('"', end + 2);
  }
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view content = rest_.substr(1, end - 1);
  rest_.remove_prefix(end + 1);
  for (std::size_t i = 0; i < content.size(); ++i) {
    const bool ends_line =
        content[i] == '\n' || (content[i] == '\r' && !content.substr(i + 1).starts_with('\n'));
    if (ends_line) ++next_line_;
  }
  return content;
}

}  // namespace brume
