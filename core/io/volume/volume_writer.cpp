
#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/volume/openvdb_grid.h"
#include "core/io/volume/volume_file.h"

namespace brume {
namespace {

// OpenVDB's own file ignores what becomes of its stream: on a full disk it is truncated, unsaid.
class VdbArchive final : public openvdb::io::Archive {
 public:
  using Archive::write;
};

openvdb::math::Transform::Ptr vdb_transform(const DensityGrid& grid) {
  openvdb::math::Mat4d matrix = openvdb::math::Mat4d::identity();
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 unit(0.0);
    unit[k] = grid.spacing[k];
    const glm::dvec3 axis = grid.rotation * unit;
    // OpenVDB's matrices are applied to rows.
    matrix.setRow(k, openvdb::Vec4d(axis.x, axis.y, axis.z, 0.0));
  }
  matrix.setRow(3, openvdb::Vec4d(grid.origin.x, grid.origin.y, grid.origin.z, 1.0));
  return openvdb::math::Transform::createLinearTransform(matrix);
}

// A fog volume with the blocks of `blocks`; value_of(block, voxel) is active where it is not zero.
template <class Grid, class ValueOf>
typename Grid::Ptr vdb_fog(const char* name, const DensityGrid& blocks, ValueOf value_of) {
  using Value = typename Grid::ValueType;
  using Leaf = typename Grid::TreeType::LeafNodeType;
  const auto result = new_grid<Grid>();
  result->setName(name);
  result->setGridClass(openvdb::GRID_FOG_VOLUME);
  result->setTransform(vdb_transform(blocks));
  for (std::size_t b = 0; b < blocks.blocks.size(); ++b) {
    const glm::ivec3& corner = blocks.blocks[b].corner;
    auto* leaf = new Leaf(openvdb::Coord(corner.x, corner.y, corner.z), Value(0.0f));
    for (openvdb::Index i = 0; i < DensityGrid::block_size; ++i) {
      const Value value = value_of(b, i);
      if (value != Value(0.0f)) leaf->setValueOn(i, value);
    }
    result->tree().addLeaf(leaf);  // which takes it
  }
  return result;
}

openvdb::Vec3SGrid::Ptr vdb_colors(const char* name, const ColorGrid& colors) {
  return vdb_fog<openvdb::Vec3SGrid>(name, colors[0], [&](std::size_t b, std::size_t i) {
    return openvdb::Vec3s(colors[0].blocks[b].values[i], colors[1].blocks[b].values[i],
                          colors[2].blocks[b].values[i]);
  });
}

}  // namespace

void write_volume(const std::filesystem::path& path, const DensityGrid& density, bool half,
                  const VolumeColors& colors) {
  const auto fog = vdb_fog<openvdb::FloatGrid>(
      "density", density,
      [&](std::size_t b, std::size_t i) { return density.blocks[b].values[i]; });
  fog->setSaveFloatAsHalf(half);
  openvdb::GridCPtrVec grids{fog};
  if (colors.albedo) {
    const auto albedo = vdb_colors("albedo", *colors.albedo);
    albedo->setSaveFloatAsHalf(half);
    grids.push_back(albedo);
  }
  // Never in half precision, which ends at 65504.
  if (colors.emission) grids.push_back(vdb_colors("emission", *colors.emission));
  write_atomically(path, [&](std::ostream& out) {
    try {
      VdbArchive().write(out, grids, /*seekable=*/true);
    } catch (const openvdb::Exception& error) {
      throw InputError(path, "", std::string("cannot be written (") + error.what() + ")");
    }
  });
}

}  // namespace brume
