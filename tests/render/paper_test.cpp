#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Settings plain() {
  Settings settings;
  settings.arithmetic = Settings::Arithmetic::plain_double;
  return settings;
}

Settings reference() {
  Settings settings;
  settings.airlight = AirlightMethod::reference;
  return settings;
}

TEST(Paper, SimdFrameIsThePlainFrame) {
  Scene scene = cloud_scene(200, 2.0);
  scene.medium.set_homogeneous_density(0.03);
  scene.surfaces.push_back(wall(-0.5, 1.0));
  scene.lights.push_back({{-2, 1, 3}, {1, 5, 9}, {}});
  const Frame fast = render_frame(scene, {});
  const Frame slow = render_frame(scene, plain());
  EXPECT_LT(difference(fast.beauty, slow.beauty).relative_rmse, 2e-5);
  // The plain path drops a Gaussian below tolerance ray by ray, the SIMD path only where all rays
  // of a vector agree: they differ by what culling may leave out, not by rounding.
  EXPECT_LT(difference(fast.transmittance, slow.transmittance).relative_rmse, 2e-4);
}

// The rows of the error table in kind: good in thin media, and darker and darker in dense ones.
// The table's clouds are other random ones, so the bounds are wide on purpose.
TEST(Paper, IsAsWrongAsMeasured) {
  struct Row {
    int count;
    double depth;
    double low, high;  // of the relative RMSE
  };
  for (const Row& row : {Row{300, 0.3, 0.005, 0.06}, Row{300, 1.0, 0.05, 0.2},
                         Row{300, 3.0, 0.2, 0.5}, Row{300, 10.0, 0.45, 0.95}}) {
    SCOPED_TRACE(row.depth);
    const Scene scene = cloud_scene(row.count, row.depth);
    const Difference d =
        difference(render_frame(scene, {}).airlight, render_frame(scene, reference()).airlight);
    EXPECT_GT(d.relative_rmse, row.low);
    EXPECT_LT(d.relative_rmse, row.high);
    EXPECT_LT(d.bias, 0.0) << "the frozen attenuation errs to the dark";
  }
}

// What culling leaves out of a ray is at most the stated 1e-3 of optical depth.
TEST(Paper, CullingKeepsTheDepthOfEveryRay) {
  const Scene scene = cloud_scene(3000, 3.0);
  const Frame culled = render_frame(scene, {});
  const Frame exact = render_frame(scene, reference());
  for (std::size_t i = 0; i < culled.transmittance.size(); ++i) {
    const double depth = -std::log(static_cast<double>(culled.transmittance[i]));
    const double exact_depth = -std::log(static_cast<double>(exact.transmittance[i]));
    ASSERT_NEAR(depth, exact_depth, 1e-3 + 1e-6);
  }
}

// A medium a million times thinner, under lights a million times brighter, looks the same as a
// thin one: tolerances follow the medium.
TEST(Paper, ThinMediaAreNotCulledAway) {
  Scene thin = cloud_scene(100, 1e-3);
  Scene thinner = cloud_scene(100, 1e-9);
  for (PointLight& light : thinner.lights) light.intensity *= 1e6;
  const Frame a = render_frame(thin, {});
  const Frame b = render_frame(thinner, {});
  EXPECT_LT(difference(a.airlight, b.airlight).relative_rmse, 3e-3);
}

}  // namespace
}  // namespace brume
