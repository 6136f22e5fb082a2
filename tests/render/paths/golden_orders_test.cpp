// Radiances along single rays by orders of scattering, against those of an independent program
// (tests/golden/multiple_scattering.json).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/render/golden_rays.h"
#include "tests/render/paths/traced_scene.h"

namespace brume {
namespace {

// The golden errors of order 1 are up to 0.2%, of weak orders up to 3%: more paths would tell
// nothing more within the time of a test. BRUME_MORE_PATHS multiplies them, and prints a table.
TEST(GoldenOrders, MatchThePathTracer) {
  const char* more = std::getenv("BRUME_MORE_PATHS");
  const int paths = 32'768 * (more ? std::max(1, std::atoi(more)) : 1);
  double chi_square = 0.0;
  int comparisons = 0;
  int seed = 0;
  for (const GoldenRay& ray : golden_rays()) {
    const TracedScene scene(ray.scene, ray.albedo);
    // Seeds of their own: chi square takes the rays for independent.
    const Camera& camera = ray.scene.camera;
    const TracedScene::Estimate got =
        scene.airlight(camera.eye, camera.target, paths, static_cast<std::uint64_t>(++seed));
    const auto compare = [&](const char* order, const PathEstimate& ours, double theirs,
                             double standard_error, double bound) {
      const double error = std::hypot(ours.error.x, standard_error);
      const double z = (ours.mean.x - theirs) / error;
      EXPECT_LT(std::abs(z), bound) << ray.name << ' ' << order << ": " << ours.mean.x << " +- "
                                    << ours.error.x << ", golden " << theirs;
      if (more) {
        std::printf("%-30s %-15s %.6g +- %.2g golden %.6g z %+.2f\n", ray.name.c_str(), order,
                    ours.mean.x, ours.error.x, theirs, z);
      }
      return z;
    };
    constexpr const char* orders[] = {"order 1", "order 2", "order 3 and up"};
    for (std::size_t i = 0; i < 3; ++i) {
      // One in 16,000 is farther off.
      const double z = compare(orders[i], got.orders[i], ray.orders[i], ray.order_errors[i], 4.0);
      chi_square += z * z;
      ++comparisons;
    }
    compare("all", got.sum, ray.radiance, ray.standard_error, 3.0);
  }
  ASSERT_EQ(comparisons, 60);
  // 60 expected, with a standard deviation of 11.
  EXPECT_LT(chi_square, 60.0 + 3.0 * std::sqrt(2.0 * 60.0));
  if (more) std::printf("chi square of %d orders: %.1f\n", comparisons, chi_square);
}

}  // namespace
}  // namespace brume
