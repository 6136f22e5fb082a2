#include "core/io/volume_file.h"

#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/limits.h"
#include "core/io/number_domain.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

using Path = std::filesystem::path;

void initialize_openvdb() {
  static const bool once = [] {
    openvdb::initialize();
    return true;
  }();
  static_cast<void>(once);
}

// Calls read(open file); whatever OpenVDB finds wrong becomes an InputError.
template <class Read>
auto with_file(const Path& path, Read read) {
  if (regular_file_size(path) > limits::file_bytes) {
    throw InputError(path, "",
                     "the file is larger than " + std::to_string(limits::file_bytes) + " bytes");
  }
  initialize_openvdb();
  try {
    openvdb::io::File file(path.string());
    file.open(/*delayLoad=*/false);
    return read(file);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    // Its messages name types, functions and sometimes the file again.
    throw InputError(path, "", std::string("not a readable OpenVDB file (") + error.what() + ")");
  }
}

glm::dvec3 to_glm(const openvdb::Vec3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::string names_of(openvdb::io::File& file) {
  std::string names;
  for (auto name = file.beginName(); name != file.endName(); ++name) {
    if (!names.empty()) names += ", ";
    names += shown(name.gridName());
  }
  return names.empty() ? "none" : names;
}

// The transform as spacing, rotation and origin.
void set_transform(const Path& path, const openvdb::math::Transform& transform, DensityGrid& grid) {
  const auto point = [&](double x, double y, double z) {
    return to_glm(transform.indexToWorld(openvdb::Vec3d(x, y, z)));
  };
  grid.origin = point(0, 0, 0);
  glm::dmat3 axes;
  axes[0] = point(1, 0, 0) - grid.origin;
  axes[1] = point(0, 1, 0) - grid.origin;
  axes[2] = point(0, 0, 1) - grid.origin;
  for (int k = 0; k < 3; ++k) {
    grid.spacing[k] = glm::length(axes[k]);
    const bool fits =
        std::isfinite(grid.origin[k]) && std::abs(grid.origin[k]) <= limits::coordinate &&
        grid.spacing[k] >= limits::least_length && grid.spacing[k] <= limits::greatest_length;
    if (!fits) throw InputError(path, "transform", "its voxels have no size or place we can use");
    axes[k] /= grid.spacing[k];
  }
  const double shear =
      std::max({std::abs(glm::dot(axes[0], axes[1])), std::abs(glm::dot(axes[1], axes[2])),
                std::abs(glm::dot(axes[2], axes[0]))});
  if (!transform.isLinear() || shear > 1e-5) {
    throw InputError(path, "transform",
                     "found a sheared or perspective one; allowed: moving, turning and scaling");
  }
  if (glm::determinant(axes) < 0.0) {
    axes[0] = -axes[0];
    grid.spacing.x = -grid.spacing.x;
  }
  grid.rotation = glm::normalize(glm::quat_cast(axes));
}

template <class Grid>
DensityGrid densities(const Path& path, const std::string& name, Grid& source) {
  // Tiles, large regions of one value, are made voxels: their number is known before.
  if (source.activeVoxelCount() > limits::voxels) {
    throw InputError(path, name,
                     "found " + std::to_string(source.activeVoxelCount()) +
                         " active voxels; allowed: " + std::to_string(limits::voxels));
  }
  source.tree().voxelizeActiveTiles();
  DensityGrid grid;
  set_transform(path, source.transform(), grid);
  for (auto leaf = source.tree().cbeginLeaf(); leaf; ++leaf) {
    static_assert(std::decay_t<decltype(*leaf)>::SIZE == DensityGrid::block_size);
    const openvdb::Coord corner = leaf->origin();
    constexpr int most = 1 << 28;
    if (std::max({std::abs(corner.x()), std::abs(corner.y()), std::abs(corner.z())}) > most) {
      throw InputError(path, name, "has voxels too far from its origin");
    }
    DensityGrid::Block block{{corner.x(), corner.y(), corner.z()}, {}};
    bool is_empty = true;
    for (openvdb::Index i = 0; i < DensityGrid::block_size; ++i) {
      if (!leaf->isValueOn(i)) continue;
      const auto value = static_cast<double>(leaf->getValue(i));
      if (!std::isfinite(value) || value > limits::density) {
        throw InputError(
            path, name,
            "found a density of " + shown(value) + "; allowed: 0 to " + shown(limits::density));
      }
      if (!(value > 0.0)) continue;
      block.values[i] = static_cast<float>(value);
      is_empty = false;
    }
    if (!is_empty) grid.blocks.push_back(block);
  }
  grid.sort();
  return grid;
}

}  // namespace

DensityGrid read_volume(const Path& path, const std::string& name) {
  return with_file(path, [&](openvdb::io::File& file) {
    if (!file.hasGrid(name)) {
      throw InputError(path, "", "has no grid " + shown(name) + "; its grids: " + names_of(file));
    }
    const openvdb::GridBase::Ptr base = file.readGrid(name);
    if (base->getGridClass() == openvdb::GRID_LEVEL_SET) {
      throw InputError(path, name, "found a level set; allowed: a fog volume");
    }
    if (const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(base)) {
      return densities(path, name, *grid);
    }
    if (const auto grid = openvdb::gridPtrCast<openvdb::DoubleGrid>(base)) {
      return densities(path, name, *grid);
    }
    if (const auto grid = openvdb::gridPtrCast<openvdb::Int32Grid>(base)) {
      return densities(path, name, *grid);
    }
    throw InputError(path, name,
                     "found values of type " + base->valueType() + "; allowed: one number each");
  });
}

std::vector<VolumeGridInfo> volume_grids(const Path& path) {
  return with_file(path, [&](openvdb::io::File& file) {
    std::vector<VolumeGridInfo> result;
    for (auto name = file.beginName(); name != file.endName(); ++name) {
      const openvdb::GridBase::Ptr grid = file.readGrid(name.gridName());
      VolumeGridInfo& info = result.emplace_back();
      info.name = grid->getName();
      info.type = grid->valueType();
      info.voxels = grid->activeVoxelCount();
      info.voxel_size = to_glm(grid->voxelSize());
      if (info.voxels == 0) continue;
      const openvdb::BBoxd box = grid->transform().indexToWorld(grid->evalActiveVoxelBoundingBox());
      info.least = to_glm(box.min());
      info.greatest = to_glm(box.max());
    }
    return result;
  });
}

void write_volume(const Path& path, const DensityGrid& grid, bool half) {
  initialize_openvdb();
  const auto result = openvdb::FloatGrid::create(0.0f);
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
  write_atomically(path, [&](const Path& temporary) {
    try {
      openvdb::io::File file(temporary.string());
      file.write({result});
    } catch (const openvdb::Exception& error) {
      throw InputError(path, "", std::string("cannot be written (") + error.what() + ")");
    }
  });
}

}  // namespace brume
