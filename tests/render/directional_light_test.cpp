// Directional lights, as every method sees them.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/point_lights.h"
#include "core/transport/optical_depth.h"
#include "render/prepare/fog_extent.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

const glm::dvec3 irradiance(6.0, 5.0, 4.0);

Light sun(const glm::dvec3& direction, double angular_diameter = 0.0) {
  Light light;
  light.intensity = irradiance;
  light.kind = light::Directional{direction, angular_diameter};
  return light;
}

Scene lit_by_sun(double depth = 1.0, double angular_diameter = 0.0) {
  Scene scene = on_film(cloud_scene(30, depth), {32, 24});
  scene.lights = {sun({-0.9, -1.4, -0.6}, angular_diameter)};
  return scene;
}

// The integral of the radiance that a ray of the camera scatters of parallel light, by small steps.
double integral(const Scene& scene, const glm::dvec3& w, double end) {
  const glm::dvec3 to_light = -glm::normalize(scene.lights[0].as<light::Directional>()->direction);
  const FogBall fog = FogExtent(scene).ball();
  const double b0 = scene.medium.homogeneous_density();
  constexpr int steps = 32000;
  const double step = end / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = step * (i + 0.5);
    const glm::dvec3 x = scene.camera.eye + t * w;
    double depth = plain_depth(scene.medium, scene.camera.eye, w, t) + b0 * t +
                   plain_depth(scene.medium, x, to_light, 1e3);
    if (b0 > 0.0) depth += b0 * fog.length(x, to_light);
    sum += plain_density(scene.medium, x) * std::exp(-depth);
  }
  return scene.lights[0].intensity.x * sum * step / (4.0 * std::numbers::pi);
}

TEST(DirectionalLight, ReferenceIsTheIntegral) {
  for (const double b0 : {0.0, 0.05}) {
    Scene scene = in_fog(lit_by_sun(), b0);
    const Frame frame = render_frame(scene, reference_settings());
    const CameraRays rays(scene.camera, scene.film);
    for (const glm::ivec2 pixel : {glm::ivec2(16, 12), {13, 9}, {18, 6}, {2, 2}}) {
      const glm::dvec3 w = glm::normalize(rays.direction(pixel.x + 0.5, pixel.y + 0.5));
      const double end = b0 > 0.0 ? FogExtent(scene).ray_distance(scene.camera.eye) : 10.0;
      const double expected = integral(scene, w, end);
      const auto at = static_cast<std::size_t>(3 * (pixel.y * 32 + pixel.x));
      EXPECT_NEAR(frame.airlight[at], expected, 1e-3 * expected + 1e-7)
          << b0 << " at " << pixel.x << ", " << pixel.y;
    }
  }
}

TEST(DirectionalLight, SlicedMatchesTheReference) {
  for (const double depth : {0.3, 3.0}) {
    for (const double b0 : {0.0, 0.05}) {
      for (const bool has_wall : {false, true}) {
        Scene scene = in_fog(lit_by_sun(depth), b0);
        // In the way of some of the light; fewer pixels show too much of the shadow's edge.
        if (has_wall) {
          scene.surfaces = {wall(0.0, 0.4)};
          scene.surfaces[0].translate = {0.5, 1.2, 0.5};
        } else {
          scene.film = {16, 12};
        }
        const Frame truth = render_frame(scene, reference_settings());
        // The edge of a shadow takes twice the slices, as of point lights.
        const Frame frame = render_frame(scene, sliced(has_wall ? 48 : 24));
        EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), 0.01)
            << "depth " << depth << " b0 " << b0 << " wall " << has_wall;
      }
    }
  }
}

TEST(DirectionalLight, AFarPointIsASun) {
  const Scene scene = lit_by_sun();
  Scene point = scene;
  const double distance = 1e4;
  point.lights = {{-distance * glm::normalize(scene.lights[0].as<light::Directional>()->direction),
                   distance * distance * irradiance}};
  for (const Settings& settings : {reference_settings(), sliced(24), all_orders(24)}) {
    EXPECT_LT(
        rel_rmse(render_frame(scene, settings).airlight, render_frame(point, settings).airlight),
        1e-3);
  }
}

TEST(DirectionalLight, AllOrdersMatchPaths) {
  for (const double b0 : {0.0, 0.1}) {
    Scene scene = in_fog(on_film(lit_by_sun(3.0), {16, 12}), b0);
    scene.surfaces = {wall(-1.2, 1.5)};
    expect_all_orders_match_paths(scene, "b0 " + std::to_string(b0));
  }
}

// Irradiance on what faces the light, whatever its disc.
TEST(DirectionalLight, LightsSurfacesAsSaid) {
  for (const double diameter : {0.0, 0.53, 60.0}) {
    Scene scene;
    scene.film = {8, 6};
    scene.camera.eye = {0.0, 0.0, 4.0};
    scene.surfaces = {wall(0.0, 5.0)};
    scene.lights = {sun({0.0, 0.0, -3.0}, diameter)};
    const double expected = 0.5 * irradiance.x / std::numbers::pi;
    const auto radiance = [&](const Settings& settings) {
      return static_cast<double>(render_frame(scene, settings).beauty[4 * (3 * 8 + 4)]);
    };
    EXPECT_NEAR(radiance(sliced(8)), expected, 1e-3 * expected) << diameter;
    // Paths choose points of the disc at random.
    EXPECT_NEAR(radiance(path_traced(1024)), expected, (diameter > 1.0 ? 1e-2 : 1e-3) * expected)
        << diameter;
  }
}

// From its umbra to full light the shadow of an edge widens with the disc.
TEST(DirectionalLight, ADiscHasPenumbras) {
  Scene scene;
  scene.film = {64, 1};
  scene.camera.vertical_fov = 1.0;  // a pixel sees 0.07 u of the wall
  scene.camera.eye = {0.0, 0.0, 4.0};
  scene.surfaces = {wall(0.0, 5.0), wall(0.0, 1.0)};
  scene.surfaces[1].translate = {-1.0, 0.0, 6.0};  // behind the eye
  const auto between = [&](double diameter) {
    scene.lights = {sun({0.0, 0.0, -1.0}, diameter)};
    const Frame frame = render_frame(scene, path_traced(64));
    int count = 0;
    const double full = 0.5 * irradiance.x / std::numbers::pi;
    for (std::size_t k = 0; k < 64; ++k) {
      const double share = static_cast<double>(frame.beauty[4 * k]) / full;
      count += share > 0.03 && share < 0.97 ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(between(0.0), 0);
  EXPECT_GT(between(10.0), 5);
}

TEST(DirectionalLight, PointsOfADiscAreItsIrradiance) {
  Scene scene;
  scene.lights = {sun({0.0, -2.0, 0.0}, 30.0)};
  const LitRegion region = LitRegion::of(scene);
  glm::dvec3 sum(0.0);
  for (const PointLight& light : point_lights(scene, LightPoints::few)) {
    const glm::dvec3 q = light.position - region.center;
    const double cosine = glm::normalize(q).y;
    EXPECT_GT(cosine, std::cos(glm::radians(15.0)));
    sum += cosine * light.intensity / glm::dot(q, q);
  }
  EXPECT_NEAR(sum.x, irradiance.x, 1e-9);
  EXPECT_EQ(point_lights(scene).size(), 1u);
}

// While a medium is painted, shadow maps are not made anew.
TEST(DirectionalLight, StaysPutWhileAMediumGrows) {
  Scene scene = lit_by_sun();
  const glm::dvec3 before = point_lights(scene)[0].position;
  scene.medium.append({{0.1, 0.2, 0.0}, 0.2, 1.0});
  EXPECT_EQ(point_lights(scene)[0].position, before);
}

// The eight lights of a disc count as one that is off.
TEST(DirectionalLight, IsCountedOnce) {
  Scene scene = lit_by_sun(1.0, 3.0);
  scene.lights[0].on = false;
  const Frame frame = render_frame(scene, sliced(8));
  EXPECT_TRUE(is_left_out(frame, "switched off: 1"));
}

// Keyframes may pass a direction of no length; what is tiny is a direction.
TEST(DirectionalLight, AlwaysShinesSomewhere) {
  EXPECT_EQ(to_light({{0.0, 0.0, 0.0}}), glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_EQ(to_light({{0.0, 0.0, 1e-300}}), glm::dvec3(0.0, 0.0, -1.0));
  Scene scene = lit_by_sun();
  scene.lights[0].as<light::Directional>()->direction = {};
  expect_finite(render_frame(scene, sliced(8)));
}

// Grazing, in empty and in endless scenes, of all sizes.
TEST(DirectionalLight, HardCasesAreFinite) {
  Settings small_grid = all_orders(8, {.nodes = 1000, .directions = 32});
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const double b0 : {0.0, 0.1 / scale}) {
      for (const glm::dvec3& direction :
           {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1e12, 1e-12, 0.0)}) {
        Scene scene;
        scene.film = {8, 6};
        scene.camera.eye = {0.0, 0.0, 4.0 * scale};
        scene.medium.set_homogeneous_density(b0);
        scene.medium.append({{0.0, 0.0, 0.0}, scale, 2.0 / scale});
        scene.surfaces = {wall(-scale, scale)};
        scene.lights = {sun(direction, 89.0)};
        expect_finite(render_frame(scene, sliced(8)));
        expect_finite(render_frame(scene, small_grid));
        expect_finite(render_frame(scene, path_traced(1)));
        scene.surfaces.clear();
        scene.medium = Medium();
        scene.medium.set_homogeneous_density(b0);
        expect_finite(render_frame(scene, sliced(8)));
        expect_finite(render_frame(scene, small_grid));
        expect_finite(render_frame(scene, reference_settings()));
      }
    }
  }
}

}  // namespace
}  // namespace brume
