#include "core/io/copies_file.h"

#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "brume/error.h"
#include "core/io/csv_table.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/ply.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr std::array<std::string_view, 8> names{"x", "y", "z", "qw", "qx", "qy", "qz", "scale"};
constexpr const char* needed = "x, y, z; qw, qx, qy, qz or none of them; scale or not";

using Columns = std::array<std::optional<std::size_t>, names.size()>;

// The first missing one; empty: there are enough.
std::string_view missing_column(const Columns& columns) {
  const bool has_rotation = columns[3] || columns[4] || columns[5] || columns[6];
  for (std::size_t i = 0; i < (has_rotation ? 7U : 3U); ++i) {
    if (!columns[i]) return names[i];
  }
  return {};
}

class PlacementReader {
 public:
  PlacementReader(const std::filesystem::path& file, std::size_t max_count)
      : file_(file), max_count_(max_count) {}

  // `value(column, name)` reads a number of a row.
  void add(const Columns& columns, const std::string& place, auto&& value) {
    if (placements_.size() == max_count_) {
      throw InputError(
          file_, place,
          "found too many copies; allowed: as many as the memory of the scene holds, " +
              std::to_string(max_count_) + " more");
    }
    CopyPlacement& copy = placements_.emplace_back();
    std::array<double, names.size()> values{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!columns[i]) continue;
      values[i] = value(*columns[i], names[i]);
      const NumberDomain& domain = i == 7 ? domain::length : domain::coordinate;
      if (!domain.contains(values[i])) refuse(place, names[i], domain.refusal(values[i]));
    }
    copy.translate = {values[0], values[1], values[2]};
    const glm::dquat rotation(values[3], values[4], values[5], values[6]);
    const double length = glm::length(rotation);
    if (!(length > limits::min_length)) {
      refuse(place, "qw qx qy qz",
             "found a quaternion of length " + quoted_text(length) + "; allowed: any but 0");
    }
    copy.rotate = rotation / length;
    copy.scale = values[7];
  }

  CopyPlacements finish() { return std::move(placements_); }

  [[noreturn]] void refuse(const std::string& place, std::string_view name,
                           const std::string& why) const {
    throw InputError(file_, place + ", " + std::string(name), why);
  }

 private:
  const std::filesystem::path& file_;
  std::size_t max_count_;
  CopyPlacements placements_;
};

CopyPlacements read_ply(const std::filesystem::path& file, const std::string& bytes,
                        std::size_t max_count, std::vector<std::string>* warnings) {
  const PlyFile ply(file, bytes);
  if (warnings) {
    warnings->insert(warnings->end(), ply.warnings().begin(), ply.warnings().end());
  }
  const PlyFile::Element* const vertices = ply.element("vertex");
  if (!vertices) throw InputError(file, "header", "there is no element vertex");
  Columns columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    columns[i] = vertices->property(names[i]);
    if (columns[i] && vertices->properties[*columns[i]].list_count) columns[i].reset();
  }
  if (const std::string_view missing = missing_column(columns); !missing.empty()) {
    throw InputError(file, "element vertex",
                     "there is no property " + std::string(missing) + "; needed: " + needed);
  }
  PlacementReader reader(file, max_count);
  ply.for_each_row(
      [&](const PlyFile::Element& element, std::uint64_t index, const PlyFile::Row& row) {
        if (&element != vertices) return;
        reader.add(columns, "vertex " + std::to_string(index),
                   [&row](std::size_t column, std::string_view) { return row.scalars[column]; });
      });
  return reader.finish();
}

CopyPlacements read_csv(const std::filesystem::path& file, std::string bytes,
                        std::size_t max_count) {
  CsvTable table(file, std::move(bytes), "copies as PLY or CSV");
  Columns columns;
  const auto find_columns = [&] {
    for (std::size_t i = 0; i < names.size(); ++i) columns[i] = table.column(names[i]);
    return missing_column(columns).empty();
  };
  if (!table.read_heading(find_columns)) {
    throw InputError(file, "", "the file is empty; allowed: copies as PLY or CSV");
  }
  if (!find_columns()) {
    throw InputError(file, table.place(),
                     "there is no column " + std::string(missing_column(columns)) + "; found " +
                         quoted_text(table.heading()) + "; needed: " + needed);
  }
  PlacementReader reader(file, max_count);
  while (table.next_row()) {
    reader.add(columns, table.place(), [&](std::size_t column, std::string_view name) {
      const auto cell = table.cell(column);
      if (!cell) reader.refuse(table.place(), name, "is missing");
      const auto number = table.number(*cell);
      if (!number) {
        reader.refuse(table.place(), name, "found " + quoted_text(*cell) + "; allowed: a number");
      }
      return *number;
    });
  }
  return reader.finish();
}

}  // namespace

CopyPlacements read_copies(const std::filesystem::path& file, std::size_t max_count,
                           std::vector<std::string>* warnings) {
  std::string bytes = read_bytes(file);
  CopyPlacements copies = bytes.starts_with("ply") ? read_ply(file, bytes, max_count, warnings)
                                                   : read_csv(file, std::move(bytes), max_count);
  if (warnings && copies.empty()) warnings->push_back("there are no copies in it");
  return copies;
}

}  // namespace brume
