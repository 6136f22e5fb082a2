#include "core/io/gaussians/gaussian_csv.h"

#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "brume/error.h"
#include "core/io/csv_table.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

using gaussian_columns::domains;
using gaussian_columns::names;

// Reads Gaussians from the rows of a table, whose heading it takes.
class CsvReader {
 public:
  CsvReader(const std::filesystem::path& file, std::string bytes)
      : file_(file), table_(file, std::move(bytes), "Gaussians as PLY, CSV or glTF of splats") {
    const auto has_columns = [&] { return !missing_column(); };
    if (!table_.read_heading(has_columns)) {
      throw InputError(file, "", "the file is empty; allowed: Gaussians as PLY or CSV");
    }
    if (const auto missing = missing_column()) refuse_heading(*missing, "x,y,z,radius,density");
    for (std::size_t i = 0; i < names.size(); ++i) columns_.push_back(*column(i));
    optics_columns_ = find_all(gaussian_columns::optics_names);
    shape_columns_ = find_all(gaussian_columns::shape_names);
    const std::string missing = gaussian_columns::missing_of_shape(
        [&](std::string_view name) { return table_.column(name).has_value(); });
    if (!missing.empty()) refuse_heading(missing, "all columns of an ellipsoid, or none");
  }

  // nullopt at the end.
  std::optional<Gaussian> next() {
    if (!table_.next_row()) return std::nullopt;
    const auto value = numbers(columns_, names);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!domains[i]->contains(value[i])) refuse(names[i], domains[i]->refusal(value[i]));
    }
    Gaussian gaussian{{value[0], value[1], value[2]}, value[3], value[4]};
    if (!optics_columns_.empty()) {
      const auto& all = gaussian_columns::optics_names;
      gaussian.optics = gaussian_columns::optics_of(
          numbers(optics_columns_, all),
          [&](std::size_t i, const std::string& why) { refuse(all[i], why); });
    }
    if (!shape_columns_.empty()) {
      const auto& all = gaussian_columns::shape_names;
      gaussian_columns::set_shape(
          gaussian, numbers(shape_columns_, all),
          [&](std::size_t i, const std::string& why) { refuse(all[i], why); });
    }
    return gaussian;
  }

  // Appends the number in a column, if there is one, of the Gaussian that next() returned.
  void read_number(std::string_view name, std::vector<GaussianNumber>& numbers) {
    const auto found = table_.column(name);
    if (!found) return;
    const double value = number(*found, name);
    if (!gaussian_columns::is_id(value)) refuse(name, gaussian_columns::id_domain.refusal(value));
    numbers.push_back(static_cast<GaussianNumber>(value));
  }

  [[nodiscard]] std::string place() const { return table_.place(); }

 private:
  [[nodiscard]] std::optional<std::size_t> column(std::size_t i) const {
    return gaussian_columns::find_column(
        i, [&](std::string_view name) { return table_.column(name); });
  }

  [[nodiscard]] std::optional<std::string_view> missing_column() const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!column(i)) return names[i];
    }
    return std::nullopt;
  }

  // Columns of which a file has all or none.
  [[nodiscard]] std::vector<std::size_t> find_all(std::span<const std::string_view> wanted) const {
    std::vector<std::size_t> columns;
    for (const std::string_view name : wanted) {
      const auto found = table_.column(name);
      if (!found) return {};
      columns.push_back(*found);
    }
    return columns;
  }

  template <std::size_t count>
  std::array<double, count> numbers(std::span<const std::size_t> columns,
                                    const std::array<std::string_view, count>& column_names) {
    std::array<double, count> values{};
    for (std::size_t i = 0; i < count; ++i) values[i] = number(columns[i], column_names[i]);
    return values;
  }

  double number(std::size_t column, std::string_view name) {
    const auto cell = table_.cell(column);
    if (!cell) refuse(name, "is missing");
    const auto value = table_.number(*cell);
    if (!value) refuse(name, "found " + quoted_text(*cell) + "; allowed: a number");
    return *value;
  }

  [[noreturn]] void refuse(std::string_view name, const std::string& why) const {
    throw InputError(file_, table_.place() + ", " + std::string(name), why);
  }
  [[noreturn]] void refuse_heading(std::string_view missing, const std::string& needed) const {
    throw InputError(file_, table_.place(),
                     "there is no column " + std::string(missing) + "; found " +
                         quoted_text(table_.heading()) + "; needed: " + needed);
  }

  const std::filesystem::path& file_;
  CsvTable table_;
  std::vector<std::size_t> columns_;
  std::vector<std::size_t> optics_columns_;  // empty: none
  std::vector<std::size_t> shape_columns_;   // empty: none
};

}  // namespace

std::vector<Gaussian> read_gaussians_csv(const std::filesystem::path& file,
                                         std::vector<GaussianNumber>* ids, std::size_t max_count,
                                         std::vector<GaussianNumber>* groups) {
  return parse_gaussians_csv(file, read_bytes(file), ids, max_count, groups);
}

std::vector<Gaussian> parse_gaussians_csv(const std::filesystem::path& file, std::string bytes,
                                          std::vector<GaussianNumber>* ids, std::size_t max_count,
                                          std::vector<GaussianNumber>* groups) {
  CsvReader reader(file, std::move(bytes));
  std::vector<Gaussian> gaussians;
  while (const auto gaussian = reader.next()) {
    if (gaussians.size() == max_count) {
      throw InputError(
          file, reader.place(),
          "found too many Gaussians; allowed: " + gaussian_columns::allowed_count(max_count));
    }
    gaussians.push_back(*gaussian);
    if (ids) reader.read_number(gaussian_columns::id_name, *ids);
    if (groups) reader.read_number(gaussian_columns::group_name, *groups);
  }
  return gaussians;
}

void write_gaussians_csv(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                         std::span<const GaussianNumber> ids) {
  const bool has_optics = gaussian_columns::have_optics(gaussians);
  std::string text = "x,y,z,radius,density";
  const bool has_shapes = gaussian_columns::have_shapes(gaussians);
  if (has_optics) {
    for (const std::string_view name : gaussian_columns::optics_names) (text += ',') += name;
  }
  if (has_shapes) {
    for (const std::string_view name : gaussian_columns::shape_names) (text += ',') += name;
  }
  text += ids.empty() ? "\n" : ",id\n";
  const auto append = [&](auto value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
    text += ',';
  };
  const auto append_all = [&](const auto& values) {
    for (const double value : values) append(value);
  };
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const Gaussian& g = gaussians[i];
    append_all(std::array{g.center.x, g.center.y, g.center.z, g.radius, g.density});
    if (has_optics) append_all(gaussian_columns::optics_values(g.optics));
    if (has_shapes) append_all(gaussian_columns::shape_values(g));
    if (!ids.empty()) append(ids[i]);
    text.back() = '\n';
  }
  write_atomically(file, text);
}

}  // namespace brume
