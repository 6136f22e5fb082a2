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

// Places of columns of which a file has all or none.
std::vector<std::size_t> find_all(const std::vector<std::string_view>& header,
                                  std::span<const std::string_view> wanted) {
  std::vector<std::size_t> columns;
  for (const std::string_view name : wanted) {
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
  const std::vector<std::size_t> optics_columns = find_all(header, gaussian_columns::optics_names);
  const std::vector<std::size_t> shape_columns = find_all(header, gaussian_columns::shape_names);
  const std::string missing = gaussian_columns::missing_of_shape(
      [&](std::string_view name) { return std::ranges::find(header, name) != header.end(); });
  if (!missing.empty()) {
    throw InputError(file, "line 1",
                     "there is no column " + missing + "; needed beside others of an ellipsoid");
  }
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
    // Calls set(values of the columns, refusal) if the file has them.
    const auto read_all = [&]<std::size_t count>(const std::vector<std::size_t>& places,
                                                 const std::array<std::string_view, count>& all,
                                                 auto set) {
      if (places.empty()) return;
      const auto refuse = [&](std::size_t i, const std::string& why) {
        throw InputError(file, text.place() + ", " + std::string(all[i]), why);
      };
      std::array<double, count> values{};
      for (std::size_t i = 0; i < count; ++i) {
        if (places[i] >= row.size()) refuse(i, "is missing");
        const auto number = parse_number(row[places[i]]);
        if (!number) refuse(i, "found " + quoted_text(row[places[i]]) + "; allowed: a number");
        values[i] = *number;
      }
      set(values, refuse);
    };
    read_all(optics_columns, gaussian_columns::optics_names, [&](const auto& values, auto refuse) {
      gaussians.back().optics = gaussian_columns::optics_of(values, refuse);
    });
    read_all(shape_columns, gaussian_columns::shape_names, [&](const auto& values, auto refuse) {
      gaussian_columns::set_shape(gaussians.back(), values, refuse);
    });
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
