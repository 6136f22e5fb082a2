#include "core/io/gaussians/gaussian_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>

#include "brume/error.h"
#include "core/io/byte_reader.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/dropped_splats.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/gaussians/other_format.h"
#include "core/io/gaussians/splat_output.h"
#include "core/io/ply.h"
#include "core/medium/splat.h"

namespace brume {
namespace {

using gaussian_columns::domains;
using gaussian_columns::names;

constexpr std::array<std::string_view, 5> splat_names{"x", "y", "z", "opacity", "scale_0"};
constexpr std::array<std::string_view, 3> color_names{"f_dc_0", "f_dc_1", "f_dc_2"};

// Makes a Gaussian of a vertex; nullopt: a splat that is left out.
using ToGaussian =
    std::function<std::optional<Gaussian>(std::uint64_t index, const PlyFile::Row& row)>;

std::string vertex(std::uint64_t index) {
  return "vertex " + std::to_string(index);
}

// Columns of properties of one number each; nullopt if one of them is missing.
template <std::size_t count>
std::optional<std::array<std::size_t, count>> columns(
    const PlyFile::Element& vertices, const std::array<std::string_view, count>& properties) {
  std::array<std::size_t, count> result{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = vertices.property(properties[i]);
    if (!column || vertices.properties[*column].list_count) return std::nullopt;
    result[i] = *column;
  }
  return result;
}

std::optional<std::array<std::size_t, 5>> splat_columns(const PlyFile::Element& vertices) {
  return columns<5>(vertices, splat_names);
}

// Faults go to `dropped`.
ToGaussian from_splats(const PlyFile::Element& vertices, const SplatInput& input,
                       DroppedSplats& dropped) {
  const auto scale_1 = columns<1>(vertices, {"scale_1"});
  const auto scale_2 = columns<1>(vertices, {"scale_2"});
  const auto rotation_columns = columns<4>(vertices, {"rot_0", "rot_1", "rot_2", "rot_3"});
  const auto color_columns = input.has_albedos ? columns<3>(vertices, color_names) : std::nullopt;
  return [=, &dropped, indices = *splat_columns(vertices)](
             std::uint64_t index, const PlyFile::Row& row) -> std::optional<Gaussian> {
    const auto value = [&](std::size_t i) { return row.scalars[indices[i]]; };
    Splat splat;
    splat.center = {value(0), value(1), value(2)};
    splat.deviations = glm::dvec3(std::exp(value(4)));
    if (scale_1) {
      splat.deviations.y = std::exp(row.scalars[(*scale_1)[0]]);
      splat.deviations.z = scale_2 ? std::exp(row.scalars[(*scale_2)[0]]) : 0.0;
    }
    // -ln(1 - 1 / (1 + exp(-logit))) = ln(1 + exp(logit))
    const double logit = value(3);
    splat.depth = std::max(logit, 0.0) + std::log1p(std::exp(-std::abs(logit)));
    if (rotation_columns) {
      const auto component = [&](std::size_t i) { return row.scalars[(*rotation_columns)[i]]; };
      splat.rotation = unit_rotation({component(0), component(1), component(2), component(3)});
    }
    if (color_columns) {
      const auto channel = [&](std::size_t c) { return row.scalars[(*color_columns)[c]]; };
      splat.albedo = albedo_of_sh({channel(0), channel(1), channel(2)});
    }
    const Gaussian gaussian = gaussian_of(splat, input.along);
    const std::string fault = splat_fault(
        gaussian, {{"x", "y", "z"}, {"scale_0", "scale_1", "scale_2"}, "opacity", color_names});
    if (fault.empty()) return gaussian;
    dropped.add(vertex(index), fault);
    return std::nullopt;
  };
}

// Says what a file without Gaussians lacks, in words of splats if these are what it has.
[[noreturn]] void refuse_vertices(const std::filesystem::path& file,
                                  const PlyFile::Element& vertices, std::string_view missing) {
  const auto has = [&](std::string_view name) { return vertices.property(name).has_value(); };
  if (has("packed_position")) refuse_compressed_splats(file, "PlayCanvas");
  std::string needed = "x y z radius density, or x y z scale_0 opacity";
  if (has("opacity") || has("scale_0") || has("rot_0") || has("f_dc_0")) {
    missing = *std::ranges::find_if_not(splat_names, has);
    needed = "of splats x y z scale_0 opacity";
  }
  throw InputError(file, "element vertex",
                   "there is no property " + std::string(missing) + "; needed: " + needed);
}

ToGaussian from_points(const std::filesystem::path& file, const PlyFile::Element& vertices) {
  std::array<std::size_t, 5> indices{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto column = gaussian_columns::find_column(
        i, [&](std::string_view name) { return columns<1>(vertices, {name}); });
    if (!column) refuse_vertices(file, vertices, names[i]);
    indices[i] = (*column)[0];
  }
  const auto optics_columns = columns<6>(vertices, gaussian_columns::optics_names);
  const auto shape_columns = columns<7>(vertices, gaussian_columns::shape_names);
  const std::string missing = gaussian_columns::missing_of_shape(
      [&](std::string_view name) { return columns<1>(vertices, {name}).has_value(); });
  if (!missing.empty()) {
    throw InputError(file, "element vertex",
                     "there is no property " + missing + "; needed beside others of an ellipsoid");
  }
  return [=](std::uint64_t index, const PlyFile::Row& row) {
    const auto refuse = [&](std::string_view name, const std::string& why) {
      throw InputError(file, vertex(index), std::string(name) + ": " + why);
    };
    const auto values_of =
        [&]<std::size_t count>(const std::array<std::size_t, count>& properties) {
          std::array<double, count> values{};
          for (std::size_t i = 0; i < count; ++i) values[i] = row.scalars[properties[i]];
          return values;
        };
    const std::array<double, 5> value = values_of(indices);
    Gaussian g{{value[0], value[1], value[2]}, value[3], value[4]};
    if (shape_columns) {
      gaussian_columns::set_shape(g, values_of(*shape_columns),
                                  [&](std::size_t i, const std::string& why) {
                                    refuse(gaussian_columns::shape_names[i], why);
                                  });
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!domains[i]->contains(value[i])) refuse(names[i], domains[i]->refusal(value[i]));
    }
    if (optics_columns) {
      g.optics = gaussian_columns::optics_of(values_of(*optics_columns),
                                             [&](std::size_t i, const std::string& why) {
                                               refuse(gaussian_columns::optics_names[i], why);
                                             });
    }
    return std::optional(g);
  };
}

}  // namespace

std::vector<Gaussian> read_gaussians_ply(const std::filesystem::path& file,
                                         std::vector<GaussianNumber>* ids, std::size_t max_count,
                                         std::vector<GaussianNumber>* groups,
                                         const SplatInput& input,
                                         std::vector<std::string>* warnings) {
  const std::string bytes = read_bytes(file);
  const PlyFile ply(file, bytes);
  const PlyFile::Element* vertices = ply.element("vertex");
  if (vertices == nullptr) throw InputError(file, "header", "there is no element vertex");
  const bool are_splats = splat_columns(*vertices).has_value();
  if (vertices->count > max_count) {
    throw InputError(file, "element vertex",
                     "found " + std::to_string(vertices->count) +
                         (are_splats ? " splats" : " Gaussians") +
                         "; allowed: " + gaussian_columns::allowed_count(max_count));
  }
  DroppedSplats dropped;
  const ToGaussian to_gaussian =
      are_splats ? from_splats(*vertices, input, dropped) : from_points(file, *vertices);
  const auto number_reader = [&](std::string_view name, std::vector<GaussianNumber>* numbers) {
    const auto column = numbers ? columns<1>(*vertices, {name}) : std::nullopt;
    return [&file, name, numbers, column](std::uint64_t index, const PlyFile::Row& row) {
      if (!column) return;
      const double number = row.scalars[(*column)[0]];
      if (!gaussian_columns::is_id(number)) {
        throw InputError(file, vertex(index),
                         std::string(name) + ": " + gaussian_columns::id_domain.refusal(number));
      }
      numbers->push_back(static_cast<GaussianNumber>(number));
    };
  };
  const auto read_id = number_reader(gaussian_columns::id_name, ids);
  const auto read_group = number_reader(gaussian_columns::group_name, groups);
  std::vector<Gaussian> gaussians;
  ply.for_each_row(
      [&](const PlyFile::Element& element, std::uint64_t index, const PlyFile::Row& row) {
        if (&element != vertices) return;
        const std::optional<Gaussian> gaussian = to_gaussian(index, row);
        if (!gaussian) return;
        gaussians.push_back(*gaussian);
        read_id(index, row);
        read_group(index, row);
      });
  dropped.report(file, static_cast<std::size_t>(vertices->count), warnings);
  if (warnings) std::ranges::copy(ply.warnings(), std::back_inserter(*warnings));
  return gaussians;
}

namespace {

// Calls visit(the element vertex, or null) with what the header says.
template <class Visit>
auto with_header(const std::filesystem::path& file, Visit visit) {
  constexpr std::size_t header_bytes = 1 << 16;
  constexpr std::string_view header_end = "end_header";
  std::string bytes = read_first_bytes(file, header_bytes);
  if (bytes.find(header_end) == std::string::npos) bytes = read_bytes(file);
  const PlyFile ply(file, bytes);
  return visit(ply.element("vertex"));
}

}  // namespace

bool has_splats_ply(const std::filesystem::path& file) {
  return with_header(file, [](const PlyFile::Element* vertices) {
    return vertices != nullptr && splat_columns(*vertices).has_value();
  });
}

std::size_t max_gaussian_count_ply(const std::filesystem::path& file) {
  return with_header(file, [](const PlyFile::Element* vertices) {
    return vertices == nullptr ? 0 : static_cast<std::size_t>(vertices->count);
  });
}

void write_gaussians_ply(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                         std::span<const GaussianNumber> ids) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Gaussians of a Brume medium\n";
  bytes += "element vertex " + std::to_string(gaussians.size()) + "\n";
  const bool has_optics = gaussian_columns::have_optics(gaussians);
  const bool has_shapes = gaussian_columns::have_shapes(gaussians);
  const auto add_property = [&](std::string_view name) {
    bytes += "property double " + std::string(name) + "\n";
  };
  std::ranges::for_each(names, add_property);
  if (has_optics) std::ranges::for_each(gaussian_columns::optics_names, add_property);
  if (has_shapes) std::ranges::for_each(gaussian_columns::shape_names, add_property);
  if (!ids.empty()) bytes += "property uint " + std::string(gaussian_columns::id_name) + "\n";
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + gaussians.size() * names.size() * sizeof(double));
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const Gaussian& g = gaussians[i];
    for (const double value : {g.center.x, g.center.y, g.center.z, g.radius, g.density}) {
      append_little_endian(bytes, value);
    }
    const auto append = [&](const auto& values) {
      for (const double value : values) append_little_endian(bytes, value);
    };
    if (has_optics) append(gaussian_columns::optics_values(g.optics));
    if (has_shapes) append(gaussian_columns::shape_values(g));
    if (!ids.empty()) append_little_endian(bytes, ids[i]);
  }
  write_atomically(file, bytes);
}

}  // namespace brume
