// The reader of OpenVDB's format against OpenVDB itself.

#include "core/io/volume/vdb_file.h"

#include <gtest/gtest.h>

#include <map>

#include "core/io/volume/openvdb_grid.h"
#include "core/io/volume/volume_file.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/random.h"

namespace brume {
namespace {

using Coord = openvdb::Coord;

// Voxels alone, full leaves and tiles of both levels, on both sides of the origin.
template <class Grid>
typename Grid::Ptr some_grid(typename Grid::ValueType unit) {
  auto grid = new_grid<Grid>();
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const glm::ivec3 voxel(random.point(300.0));
    grid->tree().setValue(Coord(voxel.x, voxel.y, voxel.z), unit * static_cast<int>(1 + i % 100));
  }
  for (int i = 0; i < 512; ++i) {
    grid->tree().setValue(Coord(-16 + i / 64, i / 8 % 8, i % 8), unit * (1 + i % 7));
  }
  grid->tree().addTile(1, Coord(1024, 0, 0), unit * 3, true);
  grid->tree().addTile(2, Coord(0, -4096, 0), unit * 5, true);
  grid->tree().addTile(1, Coord(1032, 0, 0), unit * 9, false);
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
      EXPECT_EQ(info[0].type, written->valueType());
      EXPECT_EQ(info[0].voxels, written->activeVoxelCount());
      const auto box = written->evalActiveVoxelBoundingBox();
      EXPECT_EQ(info[0].min_corner, glm::dvec3(box.min().x(), box.min().y(), box.min().z()));
      EXPECT_EQ(info[0].max_corner, glm::dvec3(box.max().x(), box.max().y(), box.max().z()));
    }
  }
}

TEST(VdbFile, ReadsEachTypeAndCompression) {
  expect_as_the_library_has_it<openvdb::FloatGrid>(0.37f);
  expect_as_the_library_has_it<openvdb::DoubleGrid>(0.37);
  expect_as_the_library_has_it<openvdb::Int32Grid>(-3);
  expect_as_the_library_has_it<openvdb::Int64Grid>(std::int64_t{1} << 40);
  expect_as_the_library_has_it<openvdb::Vec3SGrid>(openvdb::Vec3s(0.25f, -1.5f, 3.1f));
  expect_as_the_library_has_it<openvdb::Vec3DGrid>(openvdb::Vec3d(0.25, -1.5, 3.1));
}

TEST(VdbFile, ReadsEachLinearTransform) {
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

TEST(VdbFile, GridsThatShareATreeAndGridsThatAreNoNumbers) {
  const TemporaryFolder folder;
  const auto grid = some_grid<openvdb::FloatGrid>(0.37f);
  const auto twin = new_grid<openvdb::FloatGrid>();
  twin->setTree(grid->treePtr());
  twin->setName("twin");
  const auto frustum = some_grid<openvdb::FloatGrid>(0.37f);
  frustum->setName("frustum");
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
      openvdb::BBoxd(openvdb::Vec3d(0.0), openvdb::Vec3d(10.0)), 0.5, 10.0));
  const auto text = openvdb::GridBase::Ptr(new_grid<openvdb::MaskGrid>());
  text->setName("mask");
  openvdb::io::File((folder / "a.vdb").string()).write({grid, twin, frustum, text});
  std::map<std::string, std::uint64_t> voxels;
  for (const auto& info : volume_grids(folder / "a.vdb")) voxels[info.name] = info.voxels;
  EXPECT_EQ(voxels.size(), 4u);
  EXPECT_EQ(voxels["some"], grid->activeVoxelCount());
  EXPECT_EQ(voxels["twin"], grid->activeVoxelCount());
  EXPECT_TRUE(contains(error_of([&] { read_volume(folder / "a.vdb", "frustum"); }), "perspective"));
  EXPECT_TRUE(contains(error_of([&] { read_volume(folder / "a.vdb", "mask"); }), "mask"));
}

// Whatever bytes say: an answer or an InputError, at once and in little memory. Any other exception
// ends the test.
TEST(VdbFile, SurvivesDamage) {
  const TemporaryFolder folder;
  const std::string complete = content_of(std::filesystem::path(BRUME_VOLUMES) / "smoke_0025.vdb");
  Random random(7);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string damaged = complete;
    // Most of them in the first bytes, where counts and places stand.
    for (int i = 0; i < 1 + trial % 8; ++i) {
      const double within =
          random.uniform(0.0, 1.0) < 0.7 ? 4000.0 : static_cast<double>(complete.size());
      const auto offset = static_cast<std::size_t>(random.uniform(0.0, within - 1.0));
      damaged[offset] = static_cast<char>(random.uniform(0.0, 255.9));
    }
    const auto file = folder.write("a.vdb", damaged);
    for (const char* grid : {"density", "shadow"}) {
      try {
        read_volume(file, grid);
        volume_grids(file);
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace brume
