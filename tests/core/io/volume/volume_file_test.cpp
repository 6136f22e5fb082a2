#include "core/io/volume/volume_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>

#include "core/io/disk/file_bytes.h"
#include "core/io/volume/openvdb_grid.h"
#include "core/io/volume/vdb_file.h"
#include "core/io/volume/volume_optics.h"
#include "core/volume/medium_grid.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/volume/vdb_test_grid.h"
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
  const std::vector<VolumeGridInfo> grids = volume_grids(volumes / "smoke_0025.vdb");
  ASSERT_EQ(grids.size(), 5u);
  EXPECT_GE(512 * grids[1].blocks, grids[1].voxels);
  const auto ranges = value_ranges(volumes / "smoke_0025.vdb");
  ASSERT_EQ(ranges.size(), 5u);
  float max_value = 0.0f;
  for (const auto& block : grid.blocks) {
    for (const float value : block.values) max_value = std::max(max_value, value);
  }
  EXPECT_EQ(static_cast<float>(ranges[1]->max_value), max_value);
  EXPECT_GE(ranges[0]->min_value, 0.0);  // lengths of velocities
  EXPECT_FALSE(ranges[4]);               // no flames
}

TEST_F(VolumeFile, RangesAreOfFiniteValues) {
  const auto grid = openvdb::FloatGrid::create();
  const std::array values{std::numeric_limits<float>::quiet_NaN(), 2.0f, 1.0f,
                          std::numeric_limits<float>::infinity()};
  for (int i = 0; i < 4; ++i) {
    grid->getAccessor().setValue({0, 0, i}, values[static_cast<std::size_t>(i)]);
  }
  write(folder_ / "a.vdb", "density", grid);
  const auto range = value_ranges(folder_ / "a.vdb").at(0);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->min_value, 1.0);
  EXPECT_EQ(range->max_value, 2.0);
}

TEST_F(VolumeFile, RangesAreOfTheGridsThatCanBeRead) {
  const std::filesystem::path smoke = volumes / "smoke_0025.vdb";
  std::string bytes = read_bytes(smoke);
  const VdbGrid damaged = read_vdb_grids(smoke, bytes).at(1);
  for (std::uint64_t i = damaged.tree; i < damaged.end; ++i) bytes[i] = '\x7f';
  std::ofstream(folder_ / "a.vdb", std::ios::binary) << bytes;
  const auto ranges = value_ranges(folder_ / "a.vdb");
  ASSERT_EQ(ranges.size(), 5u);
  EXPECT_FALSE(ranges[1]);
  EXPECT_TRUE(ranges[2]);
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

// Colours, emissions, temperatures and flames of OpenVDB files.

constexpr int half = 6;
constexpr double voxel = 0.25;
constexpr std::size_t many = 1'000'000;

glm::dvec3 color_at(const glm::dvec3& x) {
  return 0.5 + 0.2 * x;
}

openvdb::Vec3SGrid::Ptr some_colors(const char* name) {
  return vdb_cube<openvdb::Vec3SGrid>(name, half, voxel,
                                      [](const glm::dvec3& x) { return to_vdb(color_at(x)); });
}

openvdb::FloatGrid::Ptr some_numbers(const char* name, float value = 1.0f) {
  return vdb_cube<openvdb::FloatGrid>(name, half, voxel, [=](const glm::dvec3&) { return value; });
}

class VolumeOpticsFile : public FolderTest {
 protected:
  VolumeOptics read(const openvdb::GridCPtrVec& grids, const VolumeOpticsNames& names = {},
                    double temperature_scale = 1.0, std::size_t max_blocks = many) {
    write_vdb(folder_ / "a.vdb", grids);
    return read_volume_optics(folder_ / "a.vdb", names, temperature_scale, max_blocks);
  }
  std::string refusal(const openvdb::GridCPtrVec& grids, const VolumeOpticsNames& names = {}) {
    return error_of([&] { read(grids, names); });
  }
};

TEST_F(VolumeOpticsFile, ReadsColoursUnderTheNamesOfPrograms) {
  for (const char* name : {"albedo", "color", "Cd"}) {
    const VolumeOptics optics = read({some_numbers("density"), some_colors(name)});
    ASSERT_TRUE(optics.color) << name;
    EXPECT_FALSE(optics.is_color_of_density);
    EXPECT_FALSE(optics.emission || optics.temperature || optics.flame);
    Random random(1);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 x = random.point(half * voxel);
      const auto color = optics.color->at(x);
      ASSERT_TRUE(color);
      // Linear, so that only single precision errs.
      EXPECT_LT(glm::length(*color - color_at(x)), 1e-6);
    }
    // Next to its last voxel a colour is that voxel's; beyond there is none.
    const glm::dvec3 edge(half * voxel, 0.0, 0.0);
    const glm::dvec3 beside(0.5 * voxel, 0.0, 0.0);
    EXPECT_LT(glm::length(*optics.color->at(edge + beside) - color_at(edge)), 1e-6);
    EXPECT_FALSE(optics.color->at(edge + 2.5 * beside));
  }
}

// Blender's fluid caches: a grid per channel, times the density.
TEST_F(VolumeOpticsFile, ReadsColoursSplitIntoChannels) {
  const openvdb::GridCPtrVec grids{some_numbers("density", 2.0f), some_numbers("color_r", 1.0f),
                                   some_numbers("color_g", 0.5f), some_numbers("color_b", 0.25f)};
  const VolumeOptics optics = read(grids);
  ASSERT_TRUE(optics.color);
  EXPECT_TRUE(optics.is_color_of_density);
  EXPECT_LT(glm::length(*optics.color->at({0.1, 0.2, 0.3}) - glm::dvec3(1.0, 0.5, 0.25)), 1e-6);
  const auto possible = possible_grids(OpticsRole::color, volume_grids(folder_ / "a.vdb"));
  EXPECT_EQ(possible, std::vector<std::string>{"color"});
  EXPECT_FALSE(read(grids, {.color = no_grid}).color);
}

TEST_F(VolumeOpticsFile, ReadsTemperaturesEmissionsAndFlames) {
  const auto emission = some_colors("emission");
  const openvdb::GridCPtrVec grids{some_numbers("temperature", 1.5f), some_numbers("flame", 0.5f),
                                   some_numbers("heat", 7.0f), emission};
  const VolumeOptics optics = read(grids, {}, 1000.0);
  EXPECT_FALSE(optics.color);
  ASSERT_TRUE(optics.temperature && optics.flame && optics.emission);
  EXPECT_NEAR(optics.temperature->at({0.1, 0.2, 0.3})->x, 1500.0, 1e-3);
  EXPECT_NEAR(optics.flame->at(glm::dvec3(0.0)), 0.5, 1e-6);
  EXPECT_LT(glm::length(*optics.emission->at(glm::dvec3(0.0)) - color_at(glm::dvec3(0.0))), 1e-6);
  // Other names, if they are asked for.
  const VolumeOptics others = read(
      grids, {.color = "emission", .emission = no_grid, .temperature = no_grid, .flame = "heat"});
  EXPECT_TRUE(others.color);
  EXPECT_FALSE(others.emission || others.temperature);
  EXPECT_NEAR(others.flame->at(glm::dvec3(0.0)), 7.0, 1e-6);
  // Ambient temperatures below 0, and grids without anything.
  EXPECT_FALSE(read({some_numbers("temperature", -3.0f)}).temperature);
  EXPECT_FALSE(read({vdb_cube<openvdb::Vec3SGrid>("Cd", half, voxel, [](const glm::dvec3&) {
                 return openvdb::Vec3s(0.0f);
               })}).color);
  EXPECT_TRUE(read({some_numbers("flame", 0.0f)}).flame->blocks.empty());
  // The emission of Blender's caches is a single number, of another thing.
  EXPECT_FALSE(read({some_numbers("emission")}).emission);
}

TEST_F(VolumeOpticsFile, RefusesOtherGrids) {
  const openvdb::GridCPtrVec grids{some_numbers("density"), some_colors("Cd")};
  EXPECT_TRUE(contains(refusal(grids, {.color = "paint"}), "its grids: density, Cd"));
  EXPECT_TRUE(contains(refusal(grids, {.color = "density"}), "allowed: three numbers each"));
  EXPECT_TRUE(contains(refusal(grids, {.temperature = "Cd"}), "allowed: one number each"));
  EXPECT_TRUE(contains(refusal(grids, {.flame = "Cd"}), "allowed: one number each"));
  const auto kelvin = refusal({some_numbers("temperature", 50'000.0f)});
  EXPECT_TRUE(contains(kelvin, "temperature") && contains(kelvin, "up to 40000 K"));
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(contains(refusal({some_numbers("temperature", nan)}), "nan"));
  EXPECT_TRUE(contains(refusal({some_numbers("flame", nan)}), "nan"));
  const auto colors = some_colors("color");
  colors->tree().setValue(openvdb::Coord(1, 2, 3), openvdb::Vec3s(0.0f, 0.0f, nan));
  EXPECT_TRUE(contains(refusal({colors}), "color: found nan"));
  const auto surface = some_numbers("flame");
  surface->setGridClass(openvdb::GRID_LEVEL_SET);
  EXPECT_TRUE(contains(refusal({surface}), "level set"));
}

// Each component on the same voxels, however few of them are not zero.
TEST_F(VolumeOpticsFile, DownsamplesComponentsTogether) {
  const auto colors = vdb_cube<openvdb::Vec3SGrid>("Cd", 20, voxel, [](const glm::dvec3& x) {
    return openvdb::Vec3s(1.0f, 0.5f, x == glm::dvec3(0.0) ? 1.0f : 0.0f);
  });
  const VolumeOptics optics = read({colors}, {}, 1.0, 60);
  ASSERT_TRUE(optics.color);
  EXPECT_LE(optics.color->coverage.blocks.size(), 60u);
  for (const DensityGrid& component : optics.color->components) {
    EXPECT_EQ(component.spacing, optics.color->coverage.spacing);
    EXPECT_EQ(component.origin, optics.color->coverage.origin);
  }
  const auto color = optics.color->at({4.0, 4.0, 4.0});
  ASSERT_TRUE(color);
  EXPECT_LT(glm::length(*color - glm::dvec3(1.0, 0.5, 0.0)), 1e-6);
}

TEST_F(VolumeOpticsFile, WrittenColoursAreReadBack) {
  DensityGrid density;
  density.blocks.push_back({glm::ivec3(0), {}});
  density.blocks[0].values.fill(2.0f);
  VolumeColors colors;
  colors.albedo.emplace();
  colors.emission.emplace();
  for (std::size_t k = 0; k < 3; ++k) {
    (*colors.albedo)[k] = density;
    (*colors.albedo)[k].blocks[0].values.fill(0.25f * static_cast<float>(k + 1));
    (*colors.emission)[k] = density;
    // Beyond half precision.
    (*colors.emission)[k].blocks[0].values.fill(1e5f * static_cast<float>(k));
  }
  write_volume(folder_ / "a.vdb", density, /*half=*/true, colors);
  const VolumeOptics optics = read_volume_optics(folder_ / "a.vdb", {}, 1.0, many);
  EXPECT_EQ(*optics.color->at(glm::dvec3(3.0)), glm::dvec3(0.25, 0.5, 0.75));
  EXPECT_EQ(*optics.emission->at(glm::dvec3(3.0)), glm::dvec3(0.0, 1e5, 2e5));
}

// Whatever bytes say: an answer or an InputError.
TEST_F(VolumeOpticsFile, SurvivesDamage) {
  write_vdb(folder_ / "a.vdb", {some_numbers("temperature"), some_colors("Cd"),
                                some_numbers("flame"), some_colors("emission")});
  const std::string complete = content_of(folder_ / "a.vdb");
  Random random(2);
  int refused = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::string damaged = complete;
    for (int i = 0; i < 1 + trial % 8; ++i) {
      const auto offset =
          static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(complete.size()) - 1.0));
      damaged[offset] = static_cast<char>(random.uniform(0.0, 255.9));
    }
    const auto file = folder_.write("b.vdb", damaged);
    try {
      read_volume_optics(file, {}, 1.0, many);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
}

}  // namespace

}  // namespace brume
