// Radiances along single rays by orders of scattering, against those of an independent program
// (tests/golden/multiple_scattering.json).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/render/paths/traced_scene.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using Json = nlohmann::json;

glm::dvec3 vec(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

Scene scene_of(const Json& ray) {
  Scene scene;
  for (const Json& g : ray.at("gaussians")) {
    scene.medium.append({vec(g.at("center")), g.at("radius"), g.at("density")});
  }
  for (const Json& light : ray.at("lights")) {
    scene.lights.push_back({vec(light.at("position")), glm::dvec3(light.at("intensity")), {}});
  }
  scene.optics.anisotropy = ray.at("anisotropy");
  if (const double radiance = ray.at("environment"); radiance > 0.0) {
    scene.environment.emplace().map = constant_sky(static_cast<float>(radiance));
  }
  return scene;
}

// The golden errors of order 1 are up to 0.2%, of weak orders up to 3%: more paths would tell
// nothing more within the time of a test. BRUME_MORE_PATHS multiplies them, and prints a table.
TEST(GoldenOrders, MatchThePathTracer) {
  std::ifstream file(BRUME_MULTIPLE_SCATTERING);
  const Json golden = Json::parse(file);
  const char* more = std::getenv("BRUME_MORE_PATHS");
  const int paths = 32'768 * (more ? std::max(1, std::atoi(more)) : 1);
  double chi_square = 0.0;
  int comparisons = 0;
  int seed = 0;
  for (const Json& ray : golden.at("rays")) {
    const auto name = ray.at("name").get<std::string>();
    const TracedScene scene(scene_of(ray), ray.at("albedo"));
    // Seeds of their own: chi square takes the rays for independent.
    const TracedScene::Estimate got = scene.airlight(vec(ray.at("eye")), vec(ray.at("target")),
                                                     paths, static_cast<std::uint64_t>(++seed));
    double sum = 0.0;
    const auto compare = [&](const char* order, const PathEstimate& ours, double theirs,
                             double bound) {
      const double error =
          std::hypot(ours.error.x, ray.at("standard_error").at(order).get<double>());
      const double z = (ours.mean.x - theirs) / error;
      EXPECT_LT(std::abs(z), bound) << name << ' ' << order << ": " << ours.mean.x << " +- "
                                    << ours.error.x << ", golden " << theirs;
      if (more) {
        std::printf("%-30s %-15s %.6g +- %.2g golden %.6g z %+.2f\n", name.c_str(), order,
                    ours.mean.x, ours.error.x, theirs, z);
      }
      return z;
    };
    constexpr const char* orders[] = {"order_1", "order_2", "order_3_and_up"};
    for (std::size_t i = 0; i < 3; ++i) {
      const double theirs = ray.at(orders[i]);
      sum += theirs;
      // One in 16,000 is farther off.
      const double z = compare(orders[i], got.orders[i], theirs, 4.0);
      chi_square += z * z;
      ++comparisons;
    }
    compare("all", got.sum, sum, 3.0);
  }
  ASSERT_EQ(comparisons, 60);
  // 60 expected, with a standard deviation of 11.
  EXPECT_LT(chi_square, 60.0 + 3.0 * std::sqrt(2.0 * 60.0));
  if (more) std::printf("chi square of %d orders: %.1f\n", comparisons, chi_square);
}

}  // namespace
}  // namespace brume
