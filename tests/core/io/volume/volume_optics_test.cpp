// Colours, emissions, temperatures and flames of OpenVDB files.

#include "core/io/volume/volume_optics.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/io/volume/vdb_test_grid.h"
#include "tests/random.h"

namespace brume {
namespace {

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

class VolumeOpticsFile : public testing::Test {
 protected:
  VolumeOptics read(const openvdb::GridCPtrVec& grids, const VolumeOpticsNames& names = {},
                    double temperature_scale = 1.0, std::size_t max_blocks = many) {
    write_vdb(folder_ / "a.vdb", grids);
    return read_volume_optics(folder_ / "a.vdb", names, temperature_scale, max_blocks);
  }
  std::string refusal(const openvdb::GridCPtrVec& grids, const VolumeOpticsNames& names = {}) {
    return error_of([&] { read(grids, names); });
  }

  TemporaryFolder folder_;
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
