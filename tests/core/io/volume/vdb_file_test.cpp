// The reader of OpenVDB's format against OpenVDB itself.

#include "core/io/volume/vdb_file.h"

#include <gtest/gtest.h>

#include <map>
#include <type_traits>

#include "core/io/byte_reader.h"
#include "core/io/volume/openvdb_grid.h"
#include "core/io/volume/volume_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/random.h"

namespace brume {
namespace {

using Coord = openvdb::Coord;

// A multiple of a value; of booleans whether there is any.
template <class Value>
Value times(const Value& unit, int factor) {
  if constexpr (std::is_same_v<Value, bool>) {
    return factor != 0;
  } else {
    return unit * factor;
  }
}

// Voxels alone, full leaves and tiles of both levels, on both sides of the origin.
template <class Grid>
typename Grid::Ptr some_grid(typename Grid::ValueType unit) {
  auto grid = new_grid<Grid>();
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const glm::ivec3 voxel(random.point(300.0));
    grid->tree().setValue(Coord(voxel.x, voxel.y, voxel.z), times(unit, i % 100));
  }
  for (int i = 0; i < 512; ++i) {
    grid->tree().setValue(Coord(-16 + i / 64, i / 8 % 8, i % 8), times(unit, i % 7));
  }
  grid->tree().addTile(1, Coord(1024, 0, 0), times(unit, 3), true);
  grid->tree().addTile(2, Coord(0, -4096, 0), times(unit, 5), true);
  grid->tree().addTile(1, Coord(1032, 0, 0), times(unit, 9), false);
  grid->setName("some");
  return grid;
}

std::uint64_t key(const glm::ivec3& voxel) {
  std::uint64_t result = 0;
  for (int k = 0; k < 3; ++k) result = result << 21 | static_cast<std::uint64_t>(voxel[k] + 100000);
  return result;
}

// The active values of leaves, and of tiles at their corner.
std::map<std::uint64_t, glm::dvec3> values_of(const std::filesystem::path& file) {
  const std::string bytes = content_of(file);
  const std::vector<VdbGrid> grids = read_vdb_grids(file, bytes);
  const VdbGrid& grid = grids.at(0);
  ByteReader reader(file, bytes);
  reader.seek(grid.tree);
  std::map<std::uint64_t, glm::dvec3> found;
  std::vector<VdbLeaf> leaves;
  read_vdb_topology(reader, *grid.values,
                    {[&](const VdbTile& tile) { found[key(tile.corner)] = tile.value; },
                     [&](const VdbLeaf& leaf) { leaves.push_back(leaf); }});
  read_vdb_leaves(reader, *grid.values, leaves,
                  [&](const VdbLeaf& leaf, std::span<const double> values) {
                    std::size_t at = 0;
                    for (int i = 0; i < 512; ++i) {
                      if (!leaf.is_active(static_cast<std::size_t>(i))) continue;
                      glm::dvec3 value(0.0);
                      for (int k = 0; k < static_cast<int>(grid.values->components); ++k) {
                        value[k] = values[at++];
                      }
                      found[key(leaf.corner + glm::ivec3(i / 64, i / 8 % 8, i % 8))] = value;
                    }
                    EXPECT_EQ(at, values.size());
                  });
  EXPECT_EQ(reader.position(), grid.end);
  return found;
}

template <class Value>
glm::dvec3 as_vector(const Value& value) {
  if constexpr (openvdb::VecTraits<Value>::IsVec) {
    return {value.x(), value.y(), value.z()};
  } else {
    return {static_cast<double>(value), 0.0, 0.0};
  }
}

template <class Grid>
void expect_as_the_library_has_it(typename Grid::ValueType unit) {
  const TemporaryFolder folder;
  const auto grid = some_grid<Grid>(unit);
  for (const std::uint32_t compression : {0, 1, 2, 3, 4, 6}) {
    for (const bool half : {false, true}) {
      SCOPED_TRACE(grid->type() + " compression " + std::to_string(compression) +
                   (half ? " half" : ""));
      grid->setSaveFloatAsHalf(half);
      const auto path = folder / "a.vdb";
      openvdb::io::File file(path.string());
      file.setCompression(compression);
      file.write({grid});
      file.close();
      file.open(false);
      const auto written = openvdb::gridPtrCast<Grid>(file.readGrid("some"));
      file.close();
      std::map<std::uint64_t, glm::dvec3> expected;
      for (auto value = written->cbeginValueOn(); value; ++value) {
        const Coord at = value.getBoundingBox().min();
        expected[key({at.x(), at.y(), at.z()})] = as_vector(*value);
      }
      const auto found = values_of(path);
      ASSERT_EQ(found.size(), expected.size());
      EXPECT_TRUE(found == expected);
      const std::vector<VolumeGridInfo> info = volume_grids(path);
      ASSERT_EQ(info.size(), 1u);
      EXPECT_EQ("Tree_" + info[0].type + "_5_4_3", written->type());
      EXPECT_EQ(info[0].voxels, written->activeVoxelCount());
      const auto box = written->evalActiveVoxelBoundingBox();
      EXPECT_EQ(info[0].min_corner, glm::dvec3(box.min().x(), box.min().y(), box.min().z()));
      EXPECT_EQ(info[0].max_corner, glm::dvec3(box.max().x(), box.max().y(), box.max().z()));
    }
  }
}

using VdbFile = FolderTest;

TEST_F(VdbFile, ReadsEachTypeAndCompression) {
  expect_as_the_library_has_it<openvdb::FloatGrid>(0.37f);
  expect_as_the_library_has_it<openvdb::DoubleGrid>(0.37);
  expect_as_the_library_has_it<openvdb::Int32Grid>(-3);
  expect_as_the_library_has_it<openvdb::Int64Grid>(std::int64_t{1} << 40);
  expect_as_the_library_has_it<openvdb::Vec3SGrid>(openvdb::Vec3s(0.25f, -1.5f, 3.1f));
  expect_as_the_library_has_it<openvdb::Vec3DGrid>(openvdb::Vec3d(0.25, -1.5, 3.1));
  expect_as_the_library_has_it<openvdb::BoolGrid>(true);
  expect_as_the_library_has_it<openvdb::MaskGrid>(true);
}

// A file of OpenVDB 13, which has grids of half precision: a root with an
// inactive tile, and a leaf at 0 with the voxels (0, 0, 1) of 1.5 and (0, 0, 2) of 2.
std::string file_of_half_grid(std::uint32_t version) {
  std::string bytes;
  const auto add = [&](auto... numbers) { (append_little_endian(bytes, numbers), ...); };
  const auto add_text = [&](std::string_view text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes += text;
  };
  constexpr std::uint16_t quarter = 0x3400, one_and_a_half = 0x3e00, two = 0x4000;
  add(std::int64_t{0x56444220}, version, std::uint32_t{13}, std::uint32_t{0}, std::uint8_t{1});
  bytes += "00000000-0000-0000-0000-000000000000";
  add(std::uint32_t{0}, std::uint32_t{1});  // no properties, one grid
  add_text("density");
  add_text("Tree_half_5_4_3");
  add_text("");  // no parent
  const auto places = bytes.size();
  add(std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{0});
  const auto begin = static_cast<std::uint64_t>(bytes.size());
  add(std::uint32_t{0}, std::uint32_t{0});  // no compression, no properties
  add_text("UniformScaleMap");
  for (int i = 0; i < 15; ++i) add(0.5);
  add(std::int32_t{1}, std::uint16_t{0}, std::uint32_t{1}, std::uint32_t{1});
  add(std::int32_t{4096}, std::int32_t{0}, std::int32_t{0}, quarter, std::uint8_t{0});
  add(std::int32_t{0}, std::int32_t{0}, std::int32_t{0});
  for (const std::size_t size : {32 * 32 * 32, 16 * 16 * 16}) {  // of nodes whose first child is
    std::string mask(size / 8, '\0');
    bytes += '\1' + mask.substr(1) + mask + '\6' + std::string(2 * size, '\0');
  }
  const std::string leaf = '\6' + std::string(63, '\0');
  bytes += leaf;
  bytes += leaf + '\6';
  add(std::uint16_t{0}, one_and_a_half, two);
  bytes += std::string(2 * 509, '\0');
  const auto end = static_cast<std::uint64_t>(bytes.size());
  std::memcpy(bytes.data() + places, &begin, sizeof begin);
  std::memcpy(bytes.data() + places + 16, &end, sizeof end);
  return bytes;
}

TEST_F(VdbFile, ReadsGridsOfHalfPrecision) {
  const auto file = folder_.write("a.vdb", file_of_half_grid(225));
  EXPECT_TRUE(volume_warnings(file).empty());
  const DensityGrid grid = read_volume(file, "density");
  EXPECT_EQ(grid.spacing, glm::dvec3(0.5));
  EXPECT_EQ(grid.at({0, 0, 1}), 1.5);
  EXPECT_EQ(grid.at({0, 0, 2}), 2.0);
  EXPECT_EQ(grid.blocks.size(), 1u);
  EXPECT_EQ(volume_grids(file).at(0).type, "half");
}

TEST_F(VdbFile, TriesNewerVersionsWithAWarning) {
  const auto file = folder_.write("a.vdb", file_of_half_grid(226));
  EXPECT_EQ(read_volume(file, "density").at({0, 0, 1}), 1.5);
  const std::vector<std::string> warnings = volume_warnings(file);
  expect_only(warnings, "found version 226");
  const auto old = folder_.write("b.vdb", file_of_half_grid(221));
  expect_error([&] { read_volume(old, "density"); }, "allowed: 222 and later");
}

// The sum of two grids of a name, `apart` in the world.
DensityGrid sum_of_two(const openvdb::Vec3d& apart, double size_of_second = 0.5) {
  const TemporaryFolder folder;
  openvdb::GridPtrVec grids;
  for (int i = 0; i < 2; ++i) {
    const auto grid = new_grid<openvdb::FloatGrid>();
    grid->setName("density");
    grid->setTransform(
        openvdb::math::Transform::createLinearTransform(i == 0 ? 0.5 : size_of_second));
    if (i == 1) grid->transform().postTranslate(apart);
    for (int x = 0; x < 5; ++x) grid->tree().setValue(Coord(x, 2, 3), 1.0f + x);
    grids.push_back(grid);
  }
  openvdb::io::File((folder / "a.vdb").string()).write(grids);
  return read_volume(folder / "a.vdb", "density");
}

TEST_F(VdbFile, SumsGridsOfOneName) {
  const DensityGrid twice = sum_of_two(openvdb::Vec3d(0.0));
  ASSERT_EQ(twice.blocks.size(), 1u);
  EXPECT_EQ(twice.at({3, 2, 3}), 8.0);
  // 6 voxels, and thus 2 within the first grid's block and 3 in the next; and back.
  const DensityGrid apart = sum_of_two(openvdb::Vec3d(3.0, 0.0, 0.0));
  for (int x = 0; x < 5; ++x) {
    EXPECT_EQ(apart.at({x, 2, 3}), 1.0 + x);
    EXPECT_EQ(apart.at({x + 6, 2, 3}), 1.0 + x);
  }
  EXPECT_EQ(sum_of_two(openvdb::Vec3d(-1.0, 0.0, 0.0)).at({0, 2, 3}), 4.0);
  EXPECT_NEAR(sum_of_two(openvdb::Vec3d(1000.0)).integral(), 30.0 / 8.0, 1e-6);
  for (const double size : {0.5, 0.25}) {
    expect_error([&] { sum_of_two(openvdb::Vec3d(0.2), size); }, "voxels do not coincide");
  }
}

TEST_F(VdbFile, ReadsEachLinearTransform) {
  namespace math = openvdb::math;
  const TemporaryFolder folder;
  const openvdb::Vec3d move(1, -2, 3);
  math::Mat4d matrix = math::Mat4d::identity();
  matrix.setToRotation(openvdb::Vec3d(1, 2, 2), 0.7);
  matrix.postScale(openvdb::Vec3d(2, 3, 0.5));
  matrix.postTranslate(move);
  const math::MapBase::Ptr maps[] = {
      math::MapBase::Ptr(new math::ScaleMap(openvdb::Vec3d(1, 2, -3))),
      math::MapBase::Ptr(new math::UniformScaleMap(0.3)),
      math::MapBase::Ptr(new math::TranslationMap(move)),
      math::MapBase::Ptr(new math::ScaleTranslateMap(openvdb::Vec3d(1, 2, 3), move)),
      math::MapBase::Ptr(new math::UniformScaleTranslateMap(0.3, move)),
      math::MapBase::Ptr(new math::UnitaryMap(openvdb::Vec3d(0, 1, 0), 0.4)),
      math::MapBase::Ptr(new math::AffineMap(matrix))};
  for (const math::MapBase::Ptr& map : maps) {
    SCOPED_TRACE(map->type());
    const auto grid = some_grid<openvdb::FloatGrid>(0.37f);
    grid->setTransform(math::Transform::Ptr(new math::Transform(map)));
    openvdb::io::File((folder / "a.vdb").string()).write({grid});
    const std::string bytes = content_of(folder / "a.vdb");
    const VdbGrid found = read_vdb_grids(folder / "a.vdb", bytes).at(0);
    ASSERT_TRUE(found.transform);
    for (const openvdb::Vec3d& v : {openvdb::Vec3d(0.0), openvdb::Vec3d(1, 2, 3)}) {
      const openvdb::Vec3d world = map->applyMap(v);
      const glm::dvec3 ours =
          found.transform->origin + found.transform->axes * glm::dvec3(v.x(), v.y(), v.z());
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(ours[k], world[k], 1e-12);
    }
    EXPECT_GT(volume_grids(folder / "a.vdb").at(0).voxels, 300u);
  }
}

TEST_F(VdbFile, GridsThatShareATreeAndGridsThatAreNoNumbers) {
  const auto grid = some_grid<openvdb::FloatGrid>(0.37f);
  const auto twin = new_grid<openvdb::FloatGrid>();
  twin->setTree(grid->treePtr());
  twin->setName("twin");
  const auto frustum = some_grid<openvdb::FloatGrid>(0.37f);
  frustum->setName("frustum");
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
      openvdb::BBoxd(openvdb::Vec3d(0.0), openvdb::Vec3d(10.0)), 0.5, 10.0));
  const auto mask = openvdb::GridBase::Ptr(new_grid<openvdb::MaskGrid>());
  mask->setName("mask");
  openvdb::io::File((folder_ / "a.vdb").string()).write({grid, twin, frustum, mask});
  std::string bytes = content_of(folder_ / "a.vdb");
  bytes.replace(bytes.find("Tree_mask"), 9, "Tree_text");
  folder_.write("a.vdb", bytes);
  std::map<std::string, std::uint64_t> voxels;
  for (const auto& info : volume_grids(folder_ / "a.vdb")) voxels[info.name] = info.voxels;
  EXPECT_EQ(voxels.size(), 4u);
  EXPECT_EQ(voxels["some"], grid->activeVoxelCount());
  EXPECT_EQ(voxels["twin"], grid->activeVoxelCount());
  expect_error([&] { read_volume(folder_ / "a.vdb", "frustum"); }, "perspective");
  expect_error([&] { read_volume(folder_ / "a.vdb", "mask"); }, "text");
}

// Whatever bytes say: an answer or an InputError, at once and in little memory. Any other exception
// ends the test.
TEST_F(VdbFile, SurvivesDamage) {
  const std::string complete = content_of(std::filesystem::path(BRUME_VOLUMES) / "smoke_0025.vdb");
  Random random(7);
  int refused = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string damaged = complete;
    // Most of them in the first bytes, where counts and places stand.
    for (int i = 0; i < 1 + trial % 8; ++i) {
      const double within =
          random.uniform(0.0, 1.0) < 0.7 ? 4000.0 : static_cast<double>(complete.size());
      const auto offset = static_cast<std::size_t>(random.uniform(0.0, within - 1.0));
      damaged[offset] = static_cast<char>(random.uniform(0.0, 255.9));
    }
    const auto file = folder_.write("a.vdb", damaged);
    for (const char* grid : {"density", "shadow"}) {
      try {
        read_volume(file, grid);
        volume_grids(file);
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace brume
