#include "render/optical_depth/optical_depth_table.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cmath>

#include "core/scene/lights/point_lights.h"
#include "render/renderer.h"
#include "render/slices/slice_kernels.h"
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

// An update makes what a new table would hold, to a step or two of its 16 bits.
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

// The memory of their maps is bounded however many points a light would become.
TEST(Settings, ManyAreaLightsBecomeFewPointsEach) {
  Scene scene = cloud_scene(3, 1.0);
  scene.lights.clear();
  for (const std::size_t count : {30, 31, 100, 1000}) {
    Light sphere;
    sphere.kind = light::Sphere();
    scene.lights.assign(count, sphere);
    const std::size_t points = point_lights(scene, LightPoints::few).size();
    EXPECT_LE(points, max_few_points);
    EXPECT_EQ(points, count * (count == 30 ? 34 : count == 31 ? 21 : count == 100 ? 8 : 1));
  }
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
    Light light;
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
  exact.airlight = AirlightMethod::reference;
  EXPECT_LT(rel_rmse(sliced.airlight, render_frame(scene, exact).airlight), 1e-3);
}

// Also of a medium that is derived from the scene's, at an albedo below 1.
TEST(Renderer, TablesAreMadeOnceWhileTheMediumIsTheSame) {
  for (const double albedo : {1.0, 0.5}) {
    Scene scene = cloud_scene(50, 2.0);
    scene.optics.albedo = glm::dvec3(albedo);
    Renderer renderer;
    const auto light_pairs = [&] {
      return renderer.render(scene, scene.camera, scene.film, sliced_settings({}, 12))
          ->statistics.light_pairs;
    };
    EXPECT_GT(light_pairs(), 0u);
    scene.camera.eye.x += 0.1;
    EXPECT_EQ(light_pairs(), 0u);
    scene.medium.append({{0.2, 0.1, 0.0}, 0.3, 1.0});
    EXPECT_GT(light_pairs(), 0u);
  }
}

}  // namespace
}  // namespace brume
