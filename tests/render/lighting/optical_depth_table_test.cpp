#include "render/lighting/optical_depth_table.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cmath>

#include "core/medium/medium_edit.h"
#include "render/lighting/slice_kernels.h"
#include "render/renderer.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

std::vector<double> depths_of(const OpticalDepthTable& table, std::span<const glm::dvec3> points) {
  PathBatch paths;
  paths.assign(table.light(), points, std::vector<std::int32_t>(points.size(), -1));
  std::vector<float> depths(paths.padded_size());
  lookup_depths(table, paths, depths.data());
  return {depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(points.size())};
}

std::vector<glm::dvec3> points_in_the_cloud(int count) {
  Random random(3);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random.point(1.2));
  return points;
}

// Far away (a perspective map), close by and inside (octahedral ones).
constexpr std::array<glm::dvec3, 3> light_positions = {
    glm::dvec3(2, 9, 3), glm::dvec3(0.5, 1.8, 0.3), glm::dvec3(0.1, 0.2, -0.1)};

TEST(OpticalDepthTable, MatchesTheOpticalDepthOfTheMedium) {
  const Scene scene = cloud_scene(100, 2.0);
  const MediumIndex medium(scene.medium, 1e-6);
  const std::vector<glm::dvec3> points = points_in_the_cloud(500);
  for (const glm::dvec3& light : light_positions) {
    SCOPED_TRACE(light.y);
    double coarse = 0.0;
    for (const OpticalDepthTableSize size :
         {OpticalDepthTableSize{32, 16}, OpticalDepthTableSize{128, 64}}) {
      const std::vector<double> depths = depths_of(OpticalDepthTable(medium, light, size), points);
      double square = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 q = points[i] - light;
        const double d = glm::length(q);
        square += std::pow(depths[i] - medium.depth({light, q / d, d}), 2);
      }
      const double rms = std::sqrt(square / static_cast<double>(points.size()));
      if (size.radii == 16) {
        coarse = rms;
      } else {
        EXPECT_LT(rms, 0.005);
        EXPECT_LT(rms, 0.3 * coarse);
      }
    }
  }
}

// What an update makes is what a new table would hold, to a step or two of its 16 bits.
TEST(TableRadii, AreUniformOrDenserNearTheLight) {
  const TableRadii even(65, 1.0, 9.0, 4.0);
  EXPECT_EQ(even.curvature, 0.0);
  EXPECT_DOUBLE_EQ(even.radius(16), 3.0);
  EXPECT_DOUBLE_EQ(even.last(), 9.0);

  const TableRadii near(65, 1.0, 1e4, 2.0);
  EXPECT_NEAR(near.radius(32), 3.0, 1e-9);
  EXPECT_NEAR(near.last(), 1e4, 1e-6);
  for (int k = 0; k < 64; ++k) {
    const double x = near.radius(k) - near.first;
    EXPECT_NEAR(near.per_unit * x / (1.0 + near.curvature * x), k, 1e-9) << "as a look-up finds it";
    EXPECT_LT(near.radius(k), near.radius(k + 1));
  }
}

// One Gaussian as large as the world does not take the radii of a small cloud.
TEST(OpticalDepthTable, ResolvesASmallCloudInAHugeGaussian) {
  Scene scene = cloud_scene(30, 2.0);
  scene.medium.append({{0, 0, 0}, 1e4, 1e-4});
  const MediumIndex medium(scene.medium, 1e-6);
  const std::vector<glm::dvec3> points = points_in_the_cloud(500);
  const glm::dvec3 light(2, 3, 2);
  const std::vector<double> depths = depths_of(OpticalDepthTable(medium, light, {}), points);
  double square = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 q = points[i] - light;
    const double d = glm::length(q);
    square += std::pow(depths[i] - medium.depth({light, q / d, d}), 2);
  }
  // Half of the radii are left to the cloud; with even ones it is 0.7.
  EXPECT_LT(std::sqrt(square / static_cast<double>(points.size())), 0.04);
}

TEST(OpticalDepthTable, UpdatesAreExact) {
  // Small ones, each seen in some directions only.
  Random random(5);
  Medium start;
  for (int i = 0; i < 200; ++i) start.append({random.point(0.7), 0.08, random.uniform(1.0, 4.0)});
  const OpticalDepthTableSize size{64, 32};
  const std::vector<glm::dvec3> points = points_in_the_cloud(2000);
  for (const glm::dvec3& light : light_positions) {
    SCOPED_TRACE(light.y);
    Medium medium = start;
    MediumIndex index(medium, 1e-6);
    OpticalDepthTable table(index, light, size);
    const std::uint64_t whole = table.pairs;
    for (const std::size_t which : {std::size_t{3}, std::size_t{77}, std::size_t{150}}) {
      const std::array ids{medium.ids()[which]};
      Gaussian g = medium.gaussian(which);
      g.center *= 0.8;
      g.density *= 0.1;
      std::vector<TableGaussian> changed{TableGaussian(index, which)};
      MediumEdit::change(medium, ids, std::array{g}).apply(medium);
      index = MediumIndex(medium, 1e-6);
      changed.emplace_back(index, which);
      ASSERT_TRUE(table.update(index, changed));
      // A light within the edited Gaussian sees it in all directions.
      if (light != light_positions[2]) {
        EXPECT_LT(table.pairs, whole * 3 / 4);
      }
      EXPECT_GT(table.pairs, 0u);
      const std::vector<double> updated = depths_of(table, points);
      const std::vector<double> anew = depths_of(OpticalDepthTable(index, light, size), points);
      double square = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) square += std::pow(updated[i] - anew[i], 2);
      EXPECT_LT(std::sqrt(square / static_cast<double>(points.size())), 1e-3);
    }
  }
}

TEST(OpticalDepthTable, RefusesUpdatesThatItCannotRepresent) {
  Scene scene = cloud_scene(50, 1.0);
  MediumIndex index(scene.medium, 1e-6);
  const glm::dvec3 light = light_positions[0];
  OpticalDepthTable table(index, light, {32, 16});
  scene.medium.append({{6.0, 0.0, 0.0}, 0.3, 1.0});
  index = MediumIndex(scene.medium, 1e-6);
  EXPECT_FALSE(table.update(index, std::array{TableGaussian(index, 50)}));

  Scene denser = cloud_scene(50, 1.0);
  MediumIndex dense_index(denser.medium, 1e-6);
  OpticalDepthTable other(dense_index, light, {32, 16});
  denser.medium.append({{0.0, 0.0, 0.0}, 0.2, 50.0});
  dense_index = MediumIndex(denser.medium, 1e-6);
  EXPECT_FALSE(other.update(dense_index, std::array{TableGaussian(dense_index, 50)}));
}

TEST(Settings, LightMapsOfManyLightsFitIntoMemory) {
  const Settings wanted = sliced_settings({}, 64);
  EXPECT_EQ(limit_light_map_memory(wanted, 30, true), wanted);
  EXPECT_EQ(limit_light_map_memory(wanted, 64, false), wanted);
  for (const std::size_t count : {std::size_t{65}, std::size_t{300}, std::size_t{1024}}) {
    const Settings fitting = limit_light_map_memory(wanted, count, true);
    const auto directions = static_cast<std::size_t>(fitting.optical_depth_table.directions);
    const auto cells = static_cast<std::size_t>(fitting.shadow_cells);
    const std::size_t bytes =
        directions * directions * 2 * static_cast<std::size_t>(fitting.optical_depth_table.radii) +
        cells * cells * 12;
    EXPECT_LE(count * bytes, max_light_map_bytes) << count;
    EXPECT_GT(2 * count * bytes, max_light_map_bytes / 2) << count;  // no smaller than need be
    EXPECT_GE(fitting.optical_depth_table.directions, 64);
  }
}

// 17 MB for each of them would be 3.4 GB.
TEST(Renderer, ManyLightsTakeBoundedMemory) {
  Scene scene;
  scene.film = {8, 6};
  scene.medium.append({{0, 0, 0}, 1.0, 1.0});
  for (int i = 0; i < 200; ++i) {
    PointLight light;
    light.position = {2.0 + 0.01 * i, 2.0, 2.0};
    scene.lights.push_back(light);
  }
  const auto max_memory = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // [KiB]
  };
  const long before = max_memory();
  const Frame sliced = render_frame(scene, sliced_settings({}, 64));
  EXPECT_LT(max_memory() - before, 1'200'000);
  Settings exact;
  exact.airlight = AirlightMethod::march;
  exact.march_steps = 256;
  EXPECT_LT(difference(sliced.airlight, render_frame(scene, exact).airlight).relative_rmse, 1e-3);
}

class EditedMedium : public testing::TestWithParam<double> {};  // by albedo

// As in a view that is being edited: the medium tells what the edits were, also to a renderer that
// derives another medium from it.
TEST_P(EditedMedium, UpdatesPartOfTheTable) {
  Scene scene = cloud_scene(300, 2.0);
  scene.optics.albedo = glm::dvec3(GetParam());
  Settings settings = sliced_settings({}, 24);
  settings.patch_light_tables = true;
  Renderer renderer;
  const auto render = [&] { return *renderer.render(scene, scene.camera, scene.film, settings); };
  const std::uint64_t all = render().statistics.light_pairs;
  const auto change = [&](std::size_t which, double scale) {
    Gaussian g = scene.medium.gaussian(which);
    g.center *= 0.9;
    g.density *= scale;
    MediumEdit::change(scene.medium, std::array{scene.medium.ids()[which]}, std::array{g})
        .apply(scene.medium);
  };
  change(10, 0.5);
  change(20, 0.0);
  const std::array removed{scene.medium.ids()[30]};
  MediumEdit::remove(scene.medium, removed).apply(scene.medium);
  const Frame edited = render();
  EXPECT_GT(edited.statistics.light_pairs, 0u);
  EXPECT_LT(edited.statistics.light_pairs, all);
  const Frame whole = render_frame(scene, settings);
  EXPECT_LT(difference(edited.airlight, whole.airlight).relative_rmse, 1e-3);
  // b0 is not in the table.
  scene.medium.set_homogeneous_density(0.01);
  EXPECT_EQ(render().statistics.light_pairs, 0u);
}

INSTANTIATE_TEST_SUITE_P(Albedo, EditedMedium, testing::Values(1.0, 0.5));

}  // namespace
}  // namespace brume
