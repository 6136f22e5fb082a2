// Lights with photometric profiles, as every method sees them.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometric_profile.h"
#include "tests/pictures.h"
#include "tests/render/test_profiles.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Scene lit(const LightProfile& profile, const Light::Kind& kind = light::Point(),
          double depth = 1.0) {
  Scene scene = on_film(cloud_scene(30, depth), {16, 12});
  scene.lights = {{{0.4, 1.2, 0.3}, {6.0, 5.0, 4.0}, kind}};
  *profile_member(scene.lights[0]) = profile;
  return scene;
}

TEST(ProfileLight, IsotropicIsAPointLight) {
  Scene scene =
      lit({"a.ies", std::make_shared<const PhotometricProfile>(PhotometricProfile::isotropic())});
  scene.surfaces = {wall(-1.0, 2.0)};
  Scene point = scene;
  point.lights[0].kind = light::Point();
  for (const Settings& settings : {reference_settings(), sliced(24), all_orders(24)}) {
    const Frame frame = render_frame(scene, settings);
    const Frame expected = render_frame(point, settings);
    // Where a slice is long beside its distance from the light, a profile's light is attenuated
    // from where it arrives, another's from the slice's middle.
    EXPECT_LT(rel_rmse(frame.airlight, expected.airlight), 1e-3);
    EXPECT_LT(rel_rmse(frame.beauty, expected.beauty), 1e-3);
  }
}

// A disk so small that it is a point shines by the cosine from its normal.
TEST(ProfileLight, CosineIsASmallDisk) {
  const glm::dvec3 down(0.0, -1.0, 0.0);
  constexpr double radius = 1e-3;
  Scene scene = lit(cosine_profile());
  scene.surfaces = {wall(-1.0, 2.0)};
  Scene disk = scene;
  disk.lights[0].kind = light::Disk{down, radius};
  disk.lights[0].intensity /= std::numbers::pi * radius * radius;
  const Frame expected = render_frame(disk, reference_settings());
  const Frame reference = render_frame(scene, reference_settings());
  EXPECT_LT(rel_rmse(reference.airlight, expected.airlight), 5e-4);
  EXPECT_LT(rel_rmse(reference.beauty, expected.beauty), 5e-4);
  const Frame frame = render_frame(scene, sliced(24));
  EXPECT_LT(rel_rmse(frame.airlight, expected.airlight), 0.01);
}

TEST(ProfileLight, SlicedMatchesTheReference) {
  const light::Spot cone{{-0.4, -1.2, -0.5}, 20.0, 35.0};
  for (const bool in_cone : {false, true}) {
    for (const double depth : {0.3, 3.0}) {
      Scene scene = in_fog(
          lit(lobed_profile(40.0), in_cone ? Light::Kind(cone) : light::Point(), depth), 0.05);
      scene.surfaces = {wall(-1.0, 2.0)};
      const Frame truth = render_frame(scene, reference_settings(1e-4));
      const Frame frame = render_frame(scene, sliced(24));
      EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), 0.01) << depth;
      EXPECT_LT(rel_rmse(frame.beauty, truth.beauty), 0.01) << depth;
    }
  }
}

TEST(ProfileLight, AllOrdersMatchPaths) {
  Scene scene = on_film(lit(lobed_profile(0.0), light::Point(), 3.0), {16, 12});
  scene.surfaces = {wall(-1.2, 1.5)};
  expect_all_orders_match_paths(scene, "profile");
}

// Turning the profile about its axis by a turn's half is turning the light: the lobes change sides.
TEST(ProfileLight, RotatesAboutItsAxis) {
  const Scene scene = lit(lobed_profile(0.0));
  Scene opposite = lit(lobed_profile(180.0));
  const Frame frame = render_frame(scene, sliced(24));
  EXPECT_GT(rel_rmse(render_frame(opposite, sliced(24)).airlight, frame.airlight), 0.1);
  profile_member(opposite.lights[0])->rotation = 360.0;
  EXPECT_LT(rel_rmse(render_frame(opposite, sliced(24)).airlight, frame.airlight), 1e-5);
}

// Beams of a degree, a ring, light upwards only; in the eye, in a Gaussian, far away.
TEST(ProfileLight, HardCasesAreFinite) {
  const auto profile = [](std::vector<double> polar, std::vector<double> values) {
    std::vector<double> both = values;
    both.insert(both.end(), values.begin(), values.end());
    return LightProfile{"a.ies", std::make_shared<const PhotometricProfile>(
                                     std::move(polar), std::vector{0.0, 360.0}, std::move(both))};
  };
  const LightProfile profiles[] = {profile({0.0, 0.5, 1.0}, {1.0, 1.0, 0.0}),
                                   profile({90.0}, {1.0}), profile({120.0, 180.0}, {0.0, 1e20}),
                                   profile({0.0}, {1e-20})};
  Settings small_grid = all_orders(8, {.nodes = 1000, .directions = 32});
  for (const LightProfile& p : profiles) {
    Scene scene = on_film(lit(p, light::Point(), 5.0), {8, 6});
    scene.surfaces = {wall(-1.0, 2.0)};
    for (const glm::dvec3& position : {glm::dvec3(0.0), scene.camera.eye, glm::dvec3(0.0, 0.0, 2.0),
                                       glm::dvec3(0.0, 1e6, 0.0), glm::dvec3(0.0, 0.0, -1.0)}) {
      scene.lights[0].position = position;
      expect_finite(render_frame(scene, sliced(8)));
      expect_finite(render_frame(scene, small_grid));
      expect_finite(render_frame(scene, {.airlight = AirlightMethod::reference}));
    }
  }
}

// A picture in the beam, in fog and on a wall.
TEST(BeamPictures, SlicedMatchesTheReference) {
  light::Spot spot{{-0.4, -1.2, -0.5}, 33.0, 35.0};
  for (const auto& content : {quadrants_picture(), disc_picture()}) {
    spot.texture = {.file = "a.png", .content = content, .rotation = 20.0, .focus = 0.9};
    Scene scene = in_fog(on_film(lit({}, spot), {32, 24}), 0.05);
    scene.surfaces = {wall(-1.0, 2.0)};
    const Frame truth = render_frame(scene, reference_settings(1e-3));
    const Frame frame = render_frame(scene, sliced(24));
    EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), 0.015);
    EXPECT_LT(rel_rmse(frame.beauty, truth.beauty), 0.015);
    // It counts.
    Scene without = scene;
    without.lights[0].as<light::Spot>()->texture = {};
    EXPECT_GT(rel_rmse(render_frame(without, sliced(24)).airlight, truth.airlight), 0.2);
  }
}

}  // namespace
}  // namespace brume
