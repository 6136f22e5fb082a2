#include "core/io/gaussian_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussian_columns.h"
#include "core/io/limits.h"
#include "core/io/ply.h"

namespace brume {
namespace {

using gaussian_columns::domains;
using gaussian_columns::names;

void append_little_endian(std::string& bytes, double value) {
  std::array<char, sizeof(double)> raw;
  std::memcpy(raw.data(), &value, sizeof(double));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

}  // namespace

std::vector<Gaussian> read_gaussians(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  const PlyFile ply(file, bytes);
  const PlyFile::Element* vertices = ply.element("vertex");
  if (vertices == nullptr) throw InputError(file, "header", "there is no element vertex");
  if (vertices->count > limits::gaussians) {
    throw InputError(file, "element vertex",
                     "found " + std::to_string(vertices->count) + " Gaussians; allowed: at most " +
                         std::to_string(limits::gaussians));
  }
  std::array<std::size_t, 5> columns{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto column = vertices->property(names[i]);
    if (!column || vertices->properties[*column].list_count) {
      throw InputError(
          file, "element vertex",
          "there is no property " + std::string(names[i]) + "; needed: x y z radius density");
    }
    columns[i] = *column;
  }

  std::vector<Gaussian> gaussians;
  ply.for_each_row(
      [&](const PlyFile::Element& element, std::uint64_t index, const PlyFile::Row& row) {
        if (&element != vertices) return;
        std::array<double, 5> value{};
        for (std::size_t i = 0; i < names.size(); ++i) {
          value[i] = row.scalars[columns[i]];
          if (!domains[i]->contains(value[i])) {
            throw InputError(file, "vertex " + std::to_string(index),
                             std::string(names[i]) + ": " + domains[i]->refusal(value[i]));
          }
        }
        gaussians.push_back({{value[0], value[1], value[2]}, value[3], value[4]});
      });
  return gaussians;
}

void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Gaussians of a Brume medium\n";
  bytes += "element vertex " + std::to_string(gaussians.size()) + "\n";
  for (const std::string_view name : names) bytes += "property double " + std::string(name) + "\n";
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + gaussians.size() * names.size() * sizeof(double));
  for (const Gaussian& g : gaussians) {
    for (const double value : {g.center.x, g.center.y, g.center.z, g.radius, g.density}) {
      append_little_endian(bytes, value);
    }
  }
  write_atomically(file, bytes);
}

}  // namespace brume
