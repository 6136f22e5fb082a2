#include "core/io/volume/volume_file.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/volume/vdb_blocks.h"
#include "core/io/volume/vdb_file.h"
#include "core/io/volume/vdb_tree.h"
#include "core/number_domain.h"

namespace brume {
namespace {

using Path = std::filesystem::path;

// The box around active voxels, and how many they are.
struct Extent {
  std::uint64_t voxels = 0;
  std::uint64_t blocks = 0;
  glm::ivec3 min_corner{std::numeric_limits<int>::max()};
  glm::ivec3 max_corner{std::numeric_limits<int>::min()};

  void add(const glm::ivec3& low, const glm::ivec3& high) {
    min_corner = glm::min(min_corner, low);
    max_corner = glm::max(max_corner, high);
  }
};

Extent extent_of(ByteReader reader, const VdbValues& values) {
  Extent extent;
  const auto tile = [&](const VdbTile& t) {
    extent.voxels += static_cast<std::uint64_t>(std::pow(t.side, 3.0));
    extent.blocks += static_cast<std::uint64_t>(std::pow(t.side / DensityGrid::side, 3.0));
    extent.add(t.corner, t.corner + (t.side - 1));
  };
  const auto leaf = [&](const VdbLeaf& l) {
    extent.voxels += l.active();
    extent.blocks += l.active() > 0 ? 1 : 0;
    for (std::size_t i = 0; i < VdbLeaf::size; ++i) {
      const auto n = static_cast<int>(i);
      const glm::ivec3 voxel = l.corner + glm::ivec3(n / 64, n / 8 % 8, n % 8);
      if (l.is_active(i)) extent.add(voxel, voxel);
    }
  };
  read_vdb_topology(reader, values, {tile, leaf});
  return extent;
}

struct Stopped {};

// Throws Stopped.
std::optional<ValueRange> value_range(ByteReader reader, const VdbValues& values,
                                      const std::stop_token& stop) {
  std::optional<ValueRange> range;
  const auto add = [&range](double value) {
    if (!std::isfinite(value)) return;
    if (!range) range = {value, value};
    range->min_value = std::min(range->min_value, value);
    range->max_value = std::max(range->max_value, value);
  };
  std::vector<VdbLeaf> leaves;
  const auto tile = [&](const VdbTile& t) {
    add(values.components == 1 ? t.value.x : glm::length(t.value));
  };
  const auto check_stop = [&stop] {
    if (stop.stop_requested()) throw Stopped();
  };
  const auto leaf = [&](const VdbLeaf& l) {
    check_stop();
    leaves.push_back(l);
  };
  read_vdb_topology(reader, values, {tile, leaf});
  read_vdb_leaves(reader, values, leaves, [&](const VdbLeaf&, std::span<const double> numbers) {
    check_stop();
    for (std::size_t i = 0; i < numbers.size(); i += values.components) {
      add(values.components == 1
              ? numbers[i]
              : glm::length(glm::dvec3(numbers[i], numbers[i + 1], numbers[i + 2])));
    }
  });
  return range;
}

}  // namespace

DensityGrid read_volume(const Path& path, const std::string& name) {
  const std::string bytes = read_bytes(path);
  const std::vector<VdbGrid> grids = read_vdb_grids(path, bytes);
  return read_vdb_density(path, bytes, grids_named(path, grids, name));
}

std::vector<std::string> volume_warnings(const Path& path) {
  constexpr std::size_t version_end = 12;
  const std::uint32_t version = vdb_version(path, read_first_bytes(path, version_end));
  if (version <= newest_vdb_version) return {};
  return {path.string() + ": found version " + std::to_string(version) +
          " of OpenVDB's format; known: up to " + std::to_string(newest_vdb_version) +
          ". What it changed may be read wrongly"};
}

std::optional<VelocityGrid> read_velocity(const Path& path) {
  const std::string bytes = read_bytes(path);
  const std::vector<VdbGrid> grids = read_vdb_grids(path, bytes);
  for (const VdbGrid& source : grids) {
    const bool is_velocity =
        source.name == "velocity" || source.name == "vel" || source.name == "v";
    if (!is_velocity || !source.values || source.values->components != 3) continue;
    const auto speed = [&](double value) {
      if (!(std::abs(value) <= limits::coordinate)) {
        throw InputError(path, source.name, "found a speed of " + quoted_text(value));
      }
      return static_cast<float>(value);
    };
    const std::vector<VdbGrid> sources = grids_named(path, grids, source.name);
    require_fog(path, sources, 3);
    VelocityGrid grid;
    for (std::size_t k = 0; k < 3; ++k) {
      DensityGrid& component = grid.components[k];
      component = read_vdb_blocks(path, bytes, sources, k, speed);
      if (source.kind != "staggered") continue;
      // On the voxel's face of lower x, y or z.
      glm::dvec3 face(0.0);
      face[static_cast<int>(k)] = -0.5;
      component.origin = component.to_world(face);
    }
    return grid;
  }
  return std::nullopt;
}

std::vector<std::optional<ValueRange>> value_ranges(const Path& path, const std::stop_token& stop) {
  const std::string bytes = read_bytes(path);
  std::vector<std::optional<ValueRange>> result;
  for (const VdbGrid& grid : read_vdb_grids(path, bytes)) {
    result.emplace_back();
    if (!grid.values) continue;
    try {
      result.back() = value_range(vdb_tree(path, bytes, grid), *grid.values, stop);
    } catch (const InputError&) {  // the others may be readable
    } catch (const Stopped&) {
      return {};
    }
  }
  return result;
}

std::vector<VolumeGridInfo> volume_grids(const Path& path) {
  const std::string bytes = read_bytes(path);
  std::vector<VolumeGridInfo> result;
  for (const VdbGrid& grid : read_vdb_grids(path, bytes)) {
    VolumeGridInfo& info = result.emplace_back();
    info.name = grid.name;
    info.type = grid.type;
    if (!grid.transform) continue;
    const auto& [axes, origin] = *grid.transform;
    for (int k = 0; k < 3; ++k) info.voxel_size[k] = glm::length(axes[k]);
    if (!grid.values) continue;
    const Extent extent = extent_of(vdb_tree(path, bytes, grid), *grid.values);
    info.voxels = extent.voxels;
    info.blocks = extent.blocks;
    if (info.voxels == 0) continue;
    info.min_corner = glm::dvec3(std::numeric_limits<double>::infinity());
    info.max_corner = -info.min_corner;
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 upper(i & 1, i >> 1 & 1, i >> 2);
      const glm::dvec3 corner = origin + axes * glm::mix(glm::dvec3(extent.min_corner),
                                                         glm::dvec3(extent.max_corner), upper);
      info.min_corner = glm::min(info.min_corner, corner);
      info.max_corner = glm::max(info.max_corner, corner);
    }
  }
  return result;
}

}  // namespace brume
