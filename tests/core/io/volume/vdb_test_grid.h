#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>

#include "core/io/volume/openvdb_grid.h"

namespace brume {

inline openvdb::Vec3s to_vdb(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// A fog volume with the values value_at(point of the world) at the voxels of [-half, half]^3.
template <class Grid, class ValueAt>
typename Grid::Ptr vdb_cube(const std::string& name, int half, double voxel_size,
                            ValueAt value_at) {
  auto grid = new_grid<Grid>();
  grid->setName(name);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel_size));
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      for (int z = -half; z <= half; ++z) {
        const glm::dvec3 world = voxel_size * glm::dvec3(x, y, z);
        grid->tree().setValue(openvdb::Coord(x, y, z), value_at(world));
      }
    }
  }
  return grid;
}

inline void write_vdb(const std::filesystem::path& file, const openvdb::GridCPtrVec& grids) {
  openvdb::io::File(file.string()).write(grids);
}

}  // namespace brume
