// Homogeneous fog in a ball, `medium.extent`, as every method of the CPU sees it.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render/prepare/fog_extent.h"
#include "tests/render/fog_ball_frames.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

const std::vector<glm::dvec3> ball_eyes{{0.0, 0.3, 3.0}, {0.2, 0.3, 0.5}, {30.0, 10.0, -40.0}};

Light ball_sun(const glm::dvec3& direction) {
  Light light;
  light.intensity = {6.0, 6.0, 6.0};
  light.kind = light::Directional{direction};
  return light;
}

Light point_light(const glm::dvec3& position) {
  return {position, {10.0, 10.0, 10.0}, {}};
}

void set_white_sky(Scene& scene) {
  scene.environment.emplace();
  scene.environment->map = constant_sky(1.0f);
}

// Narrow enough to show the ball from afar.
void look_at_ball(Scene& scene) {
  const double distance = glm::length(scene.camera.eye);
  if (distance > 4.0) scene.camera.vertical_fov = 180.0 / distance;
}

struct BallMethod {
  std::string name;
  Settings settings;
  double error;  // of single scattering
};

std::vector<BallMethod> ball_methods() {
  Settings plain = paper_settings;
  plain.precision = Settings::Precision::plain_double;
  Settings scaled = sliced(24);
  scaled.airlight_scale = 4;
  return {{"sliced", sliced(24), 0.004},
          {"sliced, upsampled", scaled, 0.01},
          {"paper", paper_settings, 0.002},
          {"paper in double", plain, 1e-4},
          {"reference", brume::reference_settings(), 1e-4}};
}

TEST(FogExtent, IsABallWhereTheSceneSaysSo) {
  Scene scene = fog_ball_scene();
  EXPECT_EQ(FogExtent(scene).fog(), (FogBall{{0, 0, 0}, 1.0}));
  EXPECT_EQ(FogExtent(scene).ball(), FogExtent(scene).fog());
  scene.surfaces = {wall(3.0, 2.0)};
  EXPECT_EQ(FogExtent(scene).fog(), (FogBall{{0, 0, 3}, 1.0}));
  scene.optics.extent.reset();
  EXPECT_TRUE(FogExtent(scene).fog().is_endless());
  EXPECT_TRUE(FogExtent(scene).ball().is_endless());
  scene.lights = {ball_sun({0, -1, 0})};
  EXPECT_TRUE(FogExtent(scene).fog().is_endless());
  EXPECT_NEAR(FogExtent(scene).ball().radius, std::sqrt(32.0), 1e-12);
}

TEST(FogBallFrames, ABallThatAbsorbsHidesTheSkyByItsChords) {
  for (const glm::dvec3& eye : ball_eyes) {
    Scene scene = fog_ball_scene(eye);
    look_at_ball(scene);
    scene.medium.set_homogeneous_density(1.5e-6);
    scene.optics.albedo = glm::dvec3(1e-6);
    set_white_sky(scene);
    std::vector<BallMethod> all = ball_methods();
    all.push_back({"path", path_traced(4), 0.0});
    for (const BallMethod& method : all) {
      // Every pixel's integral over the sky takes long.
      const bool is_reference = method.settings.airlight == AirlightMethod::reference;
      scene.film = is_reference ? Film{4, 3} : Film{32, 24};
      const Frame frame = render_frame(scene, method.settings);
      const double bound = method.settings.airlight_scale > 1 ? 0.02 : 1e-4;
      EXPECT_LT(fog_transmittance_error(scene, frame), bound) << method.name << " from " << eye.z;
      for (std::size_t i = 0; i < frame.depth.size(); i += 7) {
        ASSERT_NEAR(frame.beauty[4 * i], fog_transmittance(scene, frame, i), bound)
            << method.name << " from " << eye.z;
      }
    }
  }
}

TEST(FogBallFrames, LightScatteredOnceIsThePlainIntegral) {
  struct Case {
    const char* name;
    std::vector<Light> lights;
    double anisotropy;
  };
  const std::vector<Case> cases{{"sun", {ball_sun({-0.9, -1.4, -0.6})}, 0.0},
                                {"sun, forward", {ball_sun({0.3, -0.2, 1.0})}, 0.6},
                                {"light in the ball", {point_light({0.2, 0.4, -0.3})}, 0.0},
                                {"light outside", {point_light({1.5, 2.0, 0.5})}, 0.3}};
  for (const glm::dvec3& eye : ball_eyes) {
    for (const Case& one : cases) {
      Scene scene = fog_ball_scene(eye);
      look_at_ball(scene);
      scene.lights = one.lights;
      scene.optics.anisotropy = one.anisotropy;
      for (const BallMethod& method : ball_methods()) {
        const bool is_paper = method.settings.airlight == AirlightMethod::paper;
        if (is_paper && one.lights[0].as<light::Directional>()) continue;  // it has none
        const Frame frame = render_frame(scene, method.settings);
        EXPECT_LT(scattered_once_error(scene, frame), method.error + 0.001)
            << method.name << ", " << one.name << " from " << eye.z;
      }
    }
  }
}

TEST(FogBallFrames, SurfacesStandBeforeInAndBehindTheBall) {
  Scene scene = fog_ball_between_walls();
  scene.lights = {point_light({1.5, 2.0, 3.0})};
  for (const BallMethod& method : ball_methods()) {
    const Frame frame = render_frame(scene, method.settings);
    const double bound = method.settings.airlight_scale > 1 ? 0.03 : 1e-4;
    EXPECT_LT(fog_transmittance_error(scene, frame), bound) << method.name;
  }
}

TEST(FogBallFrames, OrthographicCamerasSeeItFromOutsideAndWithin) {
  for (const double z : {3.0, 0.2}) {
    Scene scene = fog_ball_scene({0.1, 0.2, z});
    scene.camera.height = 2.4;
    scene.lights = {point_light({1.5, 2.0, 0.5})};
    scene.optics.anisotropy = 0.3;
    for (const BallMethod& method : ball_methods()) {
      const Frame frame = render_frame(scene, method.settings);
      const double bound = method.settings.airlight_scale > 1 ? 0.02 : 1e-4;
      EXPECT_LT(scattered_once_error(scene, frame), method.error + 0.001) << method.name;
      EXPECT_LT(fog_transmittance_error(scene, frame), bound) << method.name;
    }
  }
}

// The light on a wall behind the ball has crossed it, that on a wall beside it has not.
TEST(FogBallFrames, LightOnSurfacesCrossesTheBall) {
  for (const bool is_far : {true, false}) {
    Scene scene = fog_ball_between_walls();
    scene.lights = {is_far ? ball_sun({0.0, 0.0, -1.0}) : point_light({0.0, 0.0, 2.2})};
    Scene clear = scene;
    clear.medium.set_homogeneous_density(0.0);
    const Frame lit = render_frame(clear, sliced(24));
    for (const Settings& settings : {sliced(24), brume::reference_settings(), path_traced(64)}) {
      scene.optics.albedo = glm::dvec3(1e-3);  // light scattered onto it does not count
      scene.medium.set_homogeneous_density(0.5e-3);
      const Frame frame = render_frame(scene, settings);
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        if (!std::isfinite(frame.depth[i]) || !(lit.beauty[4 * i] > 0.0f)) continue;
        const FogBallRay ray = fog_ray_of(scene, frame, i);
        const glm::dvec3 x = ray.origin + static_cast<double>(frame.depth[i]) * ray.w;
        const glm::dvec3 q = is_far ? glm::dvec3(0, 0, 1e6) : scene.lights[0].position - x;
        const double crossed = FogExtent(scene).fog().length(x, glm::normalize(q), glm::length(q));
        const double expected = static_cast<double>(lit.beauty[4 * i]) *
                                std::exp(-0.5 * (crossed + ray.end - ray.begin));
        EXPECT_NEAR(frame.beauty[4 * i], expected, 0.01 * expected) << i << " " << is_far;
      }
    }
  }
}

// A floor larger than a ball that absorbs: with one order of scattering as with all.
TEST(FogBallFrames, SkiesLightFloorsThroughTheBall) {
  Scene scene = fog_ball_scene({0.0, 2.0, 6.0});
  scene.camera.vertical_fov = 40.0;
  scene.optics.extent = 2.0;
  scene.optics.albedo = glm::dvec3(1e-3);
  scene.medium.set_homogeneous_density(0.5e-3);
  set_white_sky(scene);
  Surface floor = wall(0.0, 3.0);
  floor.rotate = {std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0};
  scene.surfaces = {floor};
  const Frame paths = render_frame(scene, path_traced(512));
  const Frame once = render_frame(scene, sliced(24));
  EXPECT_LT(rel_rmse(once.beauty, paths.beauty), 0.02);
  EXPECT_LT(std::abs(difference(once.beauty, paths.beauty).bias), 0.01);
}

TEST(FogBallFrames, AFurnaceIsWhite) {
  for (const glm::dvec3& eye : ball_eyes) {
    for (const double density : {0.5, 2.0}) {
      Scene scene = fog_ball_scene(eye);
      look_at_ball(scene);
      scene.medium.set_homogeneous_density(density);
      set_white_sky(scene);
      const Frame frame = render_frame(scene, sliced(24, Scattering::multiple));
      double worst = 0.0;
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        worst = std::max(worst, std::abs(static_cast<double>(frame.beauty[4 * i]) - 1.0));
      }
      EXPECT_LT(worst, 0.01) << density << " from " << eye.z;
    }
  }
}

TEST(FogBallFrames, AllOrdersMatchPaths) {
  Scene scene = fog_ball_scene();
  scene.medium.set_homogeneous_density(1.0);
  for (const bool is_far : {true, false}) {
    scene.lights = {is_far ? ball_sun({-0.9, -1.4, -0.6}) : point_light({1.5, 2.0, 0.5})};
    expect_all_orders_match_paths(scene, is_far ? "sun" : "point");
  }
  scene.lights = {ball_sun({-0.9, -1.4, -0.6})};
  Scene walls = fog_ball_between_walls();
  walls.lights = scene.lights;
  expect_all_orders_match_paths(walls, "walls");
}

// A sky seen through and scattered once by a ball, alone and among Gaussians.
TEST(FogBallFrames, SkiesMatchTheReference) {
  for (const bool has_gaussians : {false, true}) {
    for (const double anisotropy : {0.0, 0.6, -0.4}) {
      Scene scene = has_gaussians ? cloud_scene(10, 0.5) : fog_ball_scene();
      scene.lights.clear();
      scene.film = {16, 12};
      scene.medium.set_homogeneous_density(0.5);
      scene.optics.extent = 1.0;
      scene.optics.anisotropy = anisotropy;
      set_white_sky(scene);
      EXPECT_LT(airlight_error(scene, sliced(24), brume::reference_settings(1e-3)), 0.02)
          << anisotropy << " " << has_gaussians;
    }
  }
}

// Thin fog that reaches a million times as far as what stands in it.
TEST(FogBallFrames, ASunCrossesAHugeBall) {
  Scene scene = fog_ball_scene({0.2, 0.3, 1.5});
  scene.surfaces = {wall(-1.0, 0.3)};
  scene.medium.set_homogeneous_density(1e-6);
  scene.optics.extent = 1e6;
  scene.lights = {ball_sun({-0.9, -1.4, -0.6})};
  for (const Settings& settings : {sliced(24), brume::reference_settings()}) {
    const Frame frame = render_frame(scene, settings);
    EXPECT_LT(scattered_once_error(scene, frame), 0.01);
    EXPECT_LT(fog_transmittance_error(scene, frame), 1e-5);
  }
}

// A ball far larger than what is seen is as fog without an end.
TEST(FogBallFrames, ALargeBallIsAsEndlessFog) {
  Scene scene = fog_ball_scene();
  scene.lights = {point_light({1.5, 2.0, 0.5})};
  scene.surfaces = {wall(-2.0, 1.0)};
  Scene endless = scene;
  scene.optics.extent = 1e6;
  endless.optics.extent.reset();
  for (const BallMethod& method : ball_methods()) {
    const Frame ball = render_frame(scene, method.settings);
    const Frame all = render_frame(endless, method.settings);
    EXPECT_LT(rel_rmse(ball.beauty, all.beauty), 1e-3) << method.name;
  }
}

}  // namespace
}  // namespace brume
