#include "core/io/volume/volume_file.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <span>
#include <string_view>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/text_scanner.h"
#include "core/io/volume/openvdb_grid.h"
#include "core/io/volume/vdb_blocks.h"
#include "core/io/volume/vdb_file.h"
#include "core/io/volume/vdb_tree.h"
#include "core/limits.h"
#include "core/number_domain.h"

namespace brume {
namespace {

using Path = std::filesystem::path;

std::string names_of(const std::vector<VdbGrid>& grids) {
  std::string names;
  for (const VdbGrid& grid : grids) {
    if (!names.empty()) names += ", ";
    names += quoted_text(grid.name);
  }
  return names.empty() ? "none" : names;
}

// Of a volume, to 0 or more.
float to_density(const Path& path, const std::string& name, double value) {
  if (!std::isfinite(value) || value > limits::density) {
    throw InputError(path, name,
                     "found a density of " + quoted_text(value) + "; allowed: 0 to " +
                         quoted_text(limits::density));
  }
  return static_cast<float>(std::max(value, 0.0));
}

const VdbGrid& grid_named(const Path& path, const std::vector<VdbGrid>& grids,
                          const std::string& name) {
  const auto it = std::find_if(grids.begin(), grids.end(),
                               [&](const VdbGrid& grid) { return grid.name == name; });
  if (it == grids.end()) {
    throw InputError(path, "",
                     "has no grid " + quoted_text(name) + "; its grids: " + names_of(grids));
  }
  return *it;
}

// The box around active voxels, and how many they are.
struct Extent {
  std::uint64_t voxels = 0;
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
    extent.add(t.corner, t.corner + (t.side - 1));
  };
  const auto leaf = [&](const VdbLeaf& l) {
    extent.voxels += l.active();
    for (std::size_t i = 0; i < VdbLeaf::size; ++i) {
      const auto n = static_cast<int>(i);
      const glm::ivec3 voxel = l.corner + glm::ivec3(n / 64, n / 8 % 8, n % 8);
      if (l.is_active(i)) extent.add(voxel, voxel);
    }
  };
  read_vdb_topology(reader, values, {tile, leaf});
  return extent;
}

// OpenVDB's own file ignores what becomes of its stream: on a full disk it is truncated, unsaid.
class VdbArchive final : public openvdb::io::Archive {
 public:
  using Archive::write;
};

}  // namespace

DensityGrid read_volume(const Path& path, const std::string& name) {
  const std::string bytes = read_bytes(path);
  const std::vector<VdbGrid> grids = read_vdb_grids(path, bytes);
  const VdbGrid& source = grid_named(path, grids, name);
  if (source.kind == "level set") {
    throw InputError(path, name, "found a level set; allowed: a fog volume");
  }
  if (source.transform && (!source.values || source.values->components != 1)) {
    throw InputError(
        path, name,
        "found values of type " + quoted_text(source.type) + "; allowed: one number each");
  }
  return read_vdb_blocks(path, bytes, source, 0,
                         [&](double value) { return to_density(path, name, value); });
}

std::optional<VelocityGrid> read_velocity(const Path& path) {
  const std::string bytes = read_bytes(path);
  for (const VdbGrid& source : read_vdb_grids(path, bytes)) {
    const bool is_velocity =
        source.name == "velocity" || source.name == "vel" || source.name == "v";
    if (!is_velocity || !source.values || source.values->components != 3) continue;
    const auto speed = [&](double value) {
      if (!(std::abs(value) <= limits::coordinate)) {
        throw InputError(path, source.name, "found a speed of " + quoted_text(value));
      }
      return static_cast<float>(value);
    };
    VelocityGrid grid;
    for (std::size_t k = 0; k < 3; ++k) {
      DensityGrid& component = grid.components[k];
      component = read_vdb_blocks(path, bytes, source, k, speed);
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

void write_volume(const Path& path, const DensityGrid& grid, bool half) {
  const auto result = new_grid<openvdb::FloatGrid>();
  result->setName("density");
  result->setGridClass(openvdb::GRID_FOG_VOLUME);
  result->setSaveFloatAsHalf(half);
  openvdb::math::Mat4d matrix = openvdb::math::Mat4d::identity();
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 unit(0.0);
    unit[k] = grid.spacing[k];
    const glm::dvec3 axis = grid.rotation * unit;
    // OpenVDB's matrices are applied to rows.
    matrix.setRow(k, openvdb::Vec4d(axis.x, axis.y, axis.z, 0.0));
  }
  matrix.setRow(3, openvdb::Vec4d(grid.origin.x, grid.origin.y, grid.origin.z, 1.0));
  result->setTransform(openvdb::math::Transform::createLinearTransform(matrix));
  for (const DensityGrid::Block& block : grid.blocks) {
    using Leaf = openvdb::FloatTree::LeafNodeType;
    auto* leaf = new Leaf(openvdb::Coord(block.corner.x, block.corner.y, block.corner.z), 0.0f);
    for (openvdb::Index i = 0; i < DensityGrid::block_size; ++i) {
      if (block.values[i] > 0.0f) leaf->setValueOn(i, block.values[i]);
    }
    result->tree().addLeaf(leaf);  // which takes it
  }
  write_atomically(path, [&](std::ostream& out) {
    try {
      VdbArchive().write(out, openvdb::GridCPtrVec{result}, /*seekable=*/true);
    } catch (const openvdb::Exception& error) {
      throw InputError(path, "", std::string("cannot be written (") + error.what() + ")");
    }
  });
}

}  // namespace brume
