#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Settings plain() {
  Settings settings = paper_settings;
  settings.precision = Settings::Precision::plain_double;
  return settings;
}

TEST(Paper, SimdFrameIsThePlainFrame) {
  Scene scene = in_fog(cloud_scene(200, 2.0), 0.03);
  scene.surfaces.push_back(wall(-0.5, 1.0));
  scene.lights.push_back({{-2, 1, 3}, {1, 5, 9}, {}});
  const Frame fast = render_frame(scene, paper_settings);
  const Frame slow = render_frame(scene, plain());
  EXPECT_LT(rel_rmse(fast.beauty, slow.beauty), 2e-5);
  // The plain path drops a Gaussian below tolerance ray by ray, the SIMD path only where all rays
  // of a vector agree: they differ by what culling may leave out, not by rounding.
  EXPECT_LT(rel_rmse(fast.transmittance, slow.transmittance), 2e-4);
}

// The rows of the error table in kind: good in thin media, and darker and darker in dense ones.
// The table's clouds are other random ones, so the bounds are wide on purpose.
TEST(Paper, HasTheDocumentedError) {
  struct Row {
    int count;
    double depth;
    double low, high;  // of the relative RMSE
  };
  for (const Row& row : {Row{300, 0.3, 0.005, 0.06}, Row{300, 1.0, 0.05, 0.2},
                         Row{300, 3.0, 0.2, 0.5}, Row{300, 10.0, 0.45, 0.95}}) {
    SCOPED_TRACE(row.depth);
    const Scene scene = cloud_scene(row.count, row.depth);
    const Difference d = difference(render_frame(scene, paper_settings).airlight,
                                    render_frame(scene, reference_settings(1e-4)).airlight);
    EXPECT_GT(d.relative_rmse, row.low);
    EXPECT_LT(d.relative_rmse, row.high);
    EXPECT_LT(d.bias, 0.0) << "the frozen attenuation errs to the dark";
  }
}

// The relative RMSE of `paper` as published and with options.
struct Gain {
  double published, with;
};
Gain gain(const Scene& scene, const PaperOptions& options) {
  const Frame reference = render_frame(scene, reference_settings(1e-4));
  Settings settings = paper_settings;
  const double published =
      rel_rmse(render_frame(scene, paper_settings).airlight, reference.airlight);
  settings.paper = options;
  return {published, rel_rmse(render_frame(scene, settings).airlight, reference.airlight)};
}

constexpr PaperOptions at_mean{.at_mean = true};
constexpr PaperOptions conserve_energy{.conserve_energy = true};
constexpr PaperOptions both{.at_mean = true, .conserve_energy = true};

TEST(PaperOptions, SimdFrameIsThePlainFrame) {
  Scene scene = in_fog(cloud_scene(200, 2.0), 0.03);
  scene.surfaces.push_back(wall(0.05, 1.0));
  scene.lights.push_back({{-2, 1, 3}, {1, 5, 9}, {}});
  for (const PaperOptions& options : {at_mean, conserve_energy, both}) {
    Settings fast = paper_settings;
    fast.paper = options;
    Settings slow = plain();
    slow.paper = options;
    const Frame frame = render_frame(scene, fast);
    // Culling leaves this out, as above.
    EXPECT_LT(rel_rmse(frame.airlight, render_frame(scene, slow).airlight), 2e-4);
    EXPECT_GT(rel_rmse(frame.airlight, render_frame(scene, paper_settings).airlight), 1e-3);
  }
}

// One Gaussian of which a surface leaves the front: the projection lies on the surface, the mean
// before it.
TEST(PaperOptions, TheMeanIsExactAtSurfaces) {
  for (const double depth : {0.1, 1.0, 5.0}) {
    Scene scene = seen_by({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0}, {24, 24});
    scene.lights.push_back({{2, 3, 2}, {10, 10, 10}, {}});
    scene.medium.append({{0, 0, 0}, 1.0, depth / 1.7724538509});
    scene.surfaces.push_back(wall(0.5, 5.0));
    const Gain g = gain(scene, at_mean);
    EXPECT_LT(g.with, 0.2 * g.published) << depth;
  }
}

// About half the error in clouds (math's table: .106 -> .049, .352 -> .181, .822 -> .543), and with
// fog around them no harm: its own airlight is left alone.
TEST(PaperOptions, EnergyHalvesTheErrorInClouds) {
  for (const double depth : {0.3, 1.0, 3.0, 10.0}) {
    Scene scene = on_film(cloud_scene(300, depth), {16, 16});
    const Gain g = gain(scene, both);
    EXPECT_LT(g.with, 0.6 * g.published) << depth;
  }
  Scene scene = in_fog(on_film(cloud_scene(300, 1.0), {16, 16}), 0.02);
  const Gain g = gain(scene, conserve_energy);
  EXPECT_LT(g.with, g.published);
}

// Energy leaves alone what it cannot mend: the same picture as without it.
TEST(PaperOptions, EnergyIsLeftAloneInDenseGaussians) {
  Scene eye_inside = cloud_scene(30, 1.0);
  eye_inside.medium.append({eye_inside.camera.eye, 0.5, 20.0});
  Scene light_inside = cloud_scene(30, 1.0);
  light_inside.medium.append({light_inside.lights[0].position, 0.5, 20.0});
  Settings settings = paper_settings;
  settings.paper = conserve_energy;
  for (const Scene& scene : {eye_inside, light_inside}) {
    EXPECT_EQ(render_frame(scene, settings).airlight, render_frame(scene, paper_settings).airlight);
  }
}

// Culling leaves at most the stated 1e-3 of optical depth out of a ray.
TEST(Paper, CullingKeepsTheDepthOfEveryRay) {
  const Scene scene = cloud_scene(3000, 3.0);
  const Frame culled = render_frame(scene, paper_settings);
  const Frame exact = render_frame(scene, reference_settings(1e-4));
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
  for (Light& light : thinner.lights) light.intensity *= 1e6;
  const Frame a = render_frame(thin, paper_settings);
  const Frame b = render_frame(thinner, paper_settings);
  EXPECT_LT(rel_rmse(a.airlight, b.airlight), 3e-3);
}

}  // namespace
}  // namespace brume
