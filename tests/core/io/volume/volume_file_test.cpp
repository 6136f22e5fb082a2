#include "core/io/volume/volume_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/io/volume/openvdb_grid.h"
#include "core/volume/medium_grid.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/random.h"

namespace brume {
namespace {

const std::filesystem::path volumes = BRUME_VOLUMES;

DensityGrid some_grid() {
  Random random(1);
  Medium medium;
  for (int i = 0; i < 5; ++i) {
    medium.append({random.point(1.0), 0.3, random.uniform(0.2, 2.0)});
  }
  DensityGrid grid = *MediumSampling::plan(medium, 0.1, 100'000)->sample();
  grid.origin = {1.0, 2.0, 3.0};
  grid.rotation = glm::normalize(glm::dquat(1.0, 0.2, 0.3, -0.4));
  return grid;
}

template <class Grid>
void write(const std::filesystem::path& file, const std::string& name, Grid grid) {
  grid->setName(name);
  openvdb::io::File(file.string()).write({grid});
}

using VolumeFile = FolderTest;

TEST_F(VolumeFile, ReadsBackWhatWasWritten) {
  const DensityGrid grid = some_grid();
  for (const bool half : {false, true}) {
    write_volume(folder_ / "a.vdb", grid, half);
    const DensityGrid read = read_volume(folder_ / "a.vdb", "density");
    ASSERT_EQ(read.blocks.size(), grid.blocks.size());
    EXPECT_LT(glm::length(read.origin - grid.origin), 1e-12);
    Random random(2);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 world = grid.to_world(random.point(20.0));
      const double expected = grid.at(grid.to_voxel(world));
      EXPECT_NEAR(read.at(read.to_voxel(world)), expected,
                  half ? std::ldexp(expected, -11) + 1e-7 : 1e-6);
    }
  }
  const std::vector<VolumeGridInfo> grids = volume_grids(folder_ / "a.vdb");
  ASSERT_EQ(grids.size(), 1u);
  EXPECT_EQ(grids[0].name, "density");
}

TEST_F(VolumeFile, ReadsSmokeOfASimulation) {
  const DensityGrid grid = read_volume(volumes / "smoke_0025.vdb", "density");
  EXPECT_NEAR(grid.spacing.x, 1.0 / 12.0, 1e-6);
  EXPECT_NEAR(grid.integral() / (935.5 / 1728.0), 1.0, 1e-3);
  EXPECT_EQ(volume_grids(volumes / "smoke_0025.vdb").size(), 5u);
}

// At the voxels' points, or each component in the middle of its face.
TEST_F(VolumeFile, ReadsVelocities) {
  const auto field = [](const openvdb::Vec3d& x) {
    return openvdb::Vec3d(1.0 + x.y(), 2.0 * x.x() - x.z(), -0.5 * x.z());
  };
  for (const bool staggered : {false, true}) {
    const auto grid = new_grid<openvdb::Vec3SGrid>();
    grid->setTransform(openvdb::math::Transform::createLinearTransform(0.5));
    if (staggered) grid->setGridClass(openvdb::GRID_STAGGERED);
    for (int i = 0; i < 1000; ++i) {
      const openvdb::Coord voxel(i / 100 - 5, i / 10 % 10 - 5, i % 10 - 5);
      openvdb::Vec3s value;
      for (int k = 0; k < 3; ++k) {
        openvdb::Vec3d at = voxel.asVec3d();
        if (staggered) at[k] -= 0.5;
        value[k] = static_cast<float>(field(0.5 * at)[k]);
      }
      grid->tree().setValue(voxel, value);
    }
    write(folder_ / "a.vdb", "vel", grid);
    const auto velocity = read_velocity(folder_ / "a.vdb");
    ASSERT_TRUE(velocity);
    Random random(3);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 x = random.point(1.5);
      const openvdb::Vec3d expected = field({x.x, x.y, x.z});
      EXPECT_LT(glm::length(velocity->at(x) - glm::dvec3(expected.x(), expected.y(), expected.z())),
                1e-5);
    }
  }
  EXPECT_TRUE(read_velocity(volumes / "smoke_0025.vdb"));
  write_volume(folder_ / "a.vdb", some_grid(), false);
  EXPECT_FALSE(read_velocity(folder_ / "a.vdb"));
}

TEST_F(VolumeFile, TilesAreVoxels) {
  const auto grid = new_grid<openvdb::DoubleGrid>();
  grid->fill(openvdb::CoordBBox(openvdb::Coord(0), openvdb::Coord(31)), 0.5);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(0.1));
  write(folder_ / "a.vdb", "smoke", grid);
  EXPECT_NEAR(read_volume(folder_ / "a.vdb", "smoke").integral(), 0.5 * std::pow(3.2, 3.0), 1e-4);
}

// 36 tiles of 128^3 voxels in a small file: 304 MB of blocks, and not twice.
TEST_F(VolumeFile, TilesTakeTheMemoryOfTheirVoxelsOnce) {
  const auto grid = new_grid<openvdb::FloatGrid>();
  grid->fill(openvdb::CoordBBox(openvdb::Coord(0), openvdb::Coord(127, 127, 36 * 128 - 1)), 0.5f);
  write(folder_ / "a.vdb", "smoke", grid);
  EXPECT_LT(std::filesystem::file_size(folder_ / "a.vdb"), 100'000u);
  const auto max_memory = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // [KiB]
  };
  const long before = max_memory();
  EXPECT_EQ(read_volume(folder_ / "a.vdb", "smoke").blocks.size(), std::size_t{36} * 4096);
  EXPECT_LT(max_memory() - before, 400 * 1024);
}

TEST_F(VolumeFile, RefusesGridsWithoutDensity) {
  const auto refusal = [&](const char* name) {
    return error_of([&] { read_volume(folder_ / "a.vdb", name); });
  };
  write_volume(folder_ / "a.vdb", some_grid(), false);
  EXPECT_TRUE(contains(refusal("smoke"), "its grids: density"));

  const auto vectors = new_grid<openvdb::Vec3SGrid>();
  vectors->tree().setValue(openvdb::Coord(1, 2, 3), openvdb::Vec3s(1.0f));
  write(folder_ / "a.vdb", "density", vectors);
  EXPECT_TRUE(contains(refusal("density"), "vec3s"));

  const auto number = new_grid<openvdb::FloatGrid>();
  number->tree().setValue(openvdb::Coord(1, 2, 3), std::numeric_limits<float>::quiet_NaN());
  write(folder_ / "a.vdb", "density", number);
  EXPECT_TRUE(contains(refusal("density"), "nan"));

  number->tree().setValue(openvdb::Coord(1, 2, 3), 1.0f);
  number->setGridClass(openvdb::GRID_LEVEL_SET);
  write(folder_ / "a.vdb", "density", number);
  EXPECT_TRUE(contains(refusal("density"), "level set"));

  number->setGridClass(openvdb::GRID_FOG_VOLUME);
  number->fill(openvdb::CoordBBox(openvdb::Coord(0), openvdb::Coord((1 << 14) - 1)), 1.0f);
  write(folder_ / "a.vdb", "density", number);
  EXPECT_TRUE(contains(refusal("density"), "active voxels"));

  const auto far = new_grid<openvdb::FloatGrid>();
  far->tree().setValue(openvdb::Coord(1 << 30, 0, 0), 1.0f);
  write(folder_ / "a.vdb", "density", far);
  EXPECT_TRUE(contains(refusal("density"), "too far"));

  const auto sheared = new_grid<openvdb::FloatGrid>();
  openvdb::math::Mat4d matrix = openvdb::math::Mat4d::identity();
  matrix(0, 1) = 0.5;
  sheared->setTransform(openvdb::math::Transform::createLinearTransform(matrix));
  sheared->tree().setValue(openvdb::Coord(1, 2, 3), 1.0f);
  write(folder_ / "a.vdb", "density", sheared);
  EXPECT_TRUE(contains(refusal("density"), "shear"));

  folder_.write("a.vdb", "no volume");
  EXPECT_TRUE(contains(refusal("density"), "a.vdb"));
  expect_error([&] { read_volume(folder_ / "b.vdb", "density"); }, "b.vdb");
}

// A box of 10^23 voxels, two of which there are.
TEST_F(VolumeFile, AllocatesNothingForEmptyVoxels) {
  const auto grid = new_grid<openvdb::FloatGrid>();
  constexpr int far = 1 << 25;
  grid->tree().setValue(openvdb::Coord(-far), 1.0f);
  grid->tree().setValue(openvdb::Coord(far), 1.0f);
  write(folder_ / "a.vdb", "density", grid);
  EXPECT_EQ(read_volume(folder_ / "a.vdb", "density").blocks.size(), 2u);
  EXPECT_EQ(volume_grids(folder_ / "a.vdb").at(0).max_corner, glm::dvec3(far));
}

TEST_F(VolumeFile, RefusesTruncatedFiles) {
  const std::string complete = content_of(volumes / "smoke_0025.vdb");
  for (std::size_t percent = 0; percent < 100; ++percent) {
    const auto file = folder_.write(
        "a.vdb", std::string_view(complete).substr(0, complete.size() * percent / 100));
    EXPECT_THROW(read_volume(file, "density"), InputError) << percent;
  }
}

}  // namespace
}  // namespace brume
