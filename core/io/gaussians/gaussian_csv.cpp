#include "core/io/gaussians/gaussian_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "brume/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

using gaussian_columns::domains;
using gaussian_columns::names;

// The cells of a line, without the blanks around them.
std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> result;
  for (;;) {
    const std::size_t comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    const std::size_t first = cell.find_first_not_of(" \t");
    cell = first == std::string_view::npos ? std::string_view{} : cell.substr(first);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
    result.push_back(cell);
    if (comma == std::string_view::npos) return result;
    line.remove_prefix(comma + 1);
  }
}

std::array<std::size_t, 5> find_columns(const std::filesystem::path& file,
                                        const std::vector<std::string_view>& header) {
  std::array<std::size_t, 5> columns{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto column =
        gaussian_columns::find_column(i, [&](std::string_view name) -> std::optional<std::size_t> {
          const auto it = std::find(header.begin(), header.end(), name);
          if (it == header.end()) return std::nullopt;
          return static_cast<std::size_t>(it - header.begin());
        });
    if (!column) {
      throw InputError(
          file, "line 1",
          "there is no column " + std::string(names[i]) + "; needed: x,y,z,radius,density");
    }
    columns[i] = *column;
  }
  return columns;
}

// Places of the columns of optics; empty without them.
std::vector<std::size_t> find_optics(const std::vector<std::string_view>& header) {
  std::vector<std::size_t> columns;
  for (const std::string_view name : gaussian_columns::optics_names) {
    const auto it = std::find(header.begin(), header.end(), name);
    if (it == header.end()) return {};
    columns.push_back(static_cast<std::size_t>(it - header.begin()));
  }
  return columns;
}

}  // namespace

std::vector<Gaussian> read_gaussians_csv(const std::filesystem::path& file,
                                         std::vector<GaussianNumber>* ids, std::size_t max_count,
                                         std::string_view number_name) {
  const std::string bytes = read_bytes(file);
  TextScanner text(bytes);
  if (!text.next_line())
    throw InputError(file, "", "the file is empty; allowed: Gaussians as PLY or CSV");
  const std::vector<std::string_view> header = cells(text.rest_of_line());
  const std::array<std::size_t, 5> columns = find_columns(file, header);
  const auto id_column = static_cast<std::size_t>(
      std::find(header.begin(), header.end(), number_name) - header.begin());
  const std::vector<std::size_t> optics_columns = find_optics(header);
  std::vector<Gaussian> gaussians;
  while (text.next_line()) {
    const std::vector<std::string_view> row = cells(text.rest_of_line());
    if (row.size() == 1 && row[0].empty()) continue;
    std::array<double, 5> value{};
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string place = text.place() + ", " + std::string(names[i]);
      if (columns[i] >= row.size()) throw InputError(file, place, "is missing");
      const auto number = parse_number(row[columns[i]]);
      if (!number) {
        throw InputError(
            file, place,
            "found " + quoted_text(row[columns[i]]) + "; allowed: " + domains[i]->allowed);
      }
      if (!domains[i]->contains(*number)) {
        throw InputError(file, place, domains[i]->refusal(*number));
      }
      value[i] = *number;
    }
    if (gaussians.size() == max_count) {
      throw InputError(
          file, text.place(),
          "found too many Gaussians; allowed: " + gaussian_columns::allowed_count(max_count));
    }
    gaussians.push_back({{value[0], value[1], value[2]}, value[3], value[4]});
    if (!optics_columns.empty()) {
      const auto place = [&](std::size_t i) {
        return text.place() + ", " + std::string(gaussian_columns::optics_names[i]);
      };
      std::array<double, 6> optics{};
      for (std::size_t i = 0; i < optics.size(); ++i) {
        const std::size_t column = optics_columns[i];
        if (column >= row.size()) throw InputError(file, place(i), "is missing");
        const auto number = parse_number(row[column]);
        if (!number) {
          throw InputError(file, place(i),
                           "found " + quoted_text(row[column]) + "; allowed: a number");
        }
        optics[i] = *number;
      }
      gaussians.back().optics = gaussian_columns::optics_of(
          optics,
          [&](std::size_t i, const std::string& why) { throw InputError(file, place(i), why); });
    }
    if (!ids || id_column == header.size()) continue;
    const auto id = id_column < row.size() ? parse_number(row[id_column]) : std::nullopt;
    if (!id || !gaussian_columns::is_id(*id)) {
      throw InputError(file, text.place() + ", " + std::string(number_name),
                       (id ? "found " + quoted_text(row[id_column]) : std::string("no number")) +
                           "; allowed: " + gaussian_columns::id_domain.allowed);
    }
    ids->push_back(static_cast<GaussianNumber>(*id));
  }
  return gaussians;
}

void write_gaussians_csv(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                         std::span<const GaussianNumber> ids) {
  const bool has_optics = gaussian_columns::have_optics(gaussians);
  std::string text = "x,y,z,radius,density";
  if (has_optics) {
    for (const std::string_view name : gaussian_columns::optics_names) (text += ',') += name;
  }
  text += ids.empty() ? "\n" : ",id\n";
  const auto append = [&](auto value, char after) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
    text += after;
  };
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const Gaussian& g = gaussians[i];
    append(g.center.x, ',');
    append(g.center.y, ',');
    append(g.center.z, ',');
    append(g.radius, ',');
    append(g.density, has_optics || !ids.empty() ? ',' : '\n');
    if (has_optics) {
      const auto values = gaussian_columns::optics_values(g.optics);
      for (std::size_t k = 0; k < values.size(); ++k) {
        append(values[k], k + 1 < values.size() || !ids.empty() ? ',' : '\n');
      }
    }
    if (!ids.empty()) append(ids[i], '\n');
  }
  write_atomically(file, text);
}

}  // namespace brume
