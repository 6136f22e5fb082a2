// Spots, suns and photometric profiles, as every method sees them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/point_lights.h"
#include "render/prepare/fog_extent.h"
#include "tests/pictures.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

Scene lit_by_spot(const light::Spot& cone, double depth = 1.0) {
  Scene scene = on_film(cloud_scene(30, depth), {32, 24});
  scene.lights = {{{0.9, 1.4, 0.6}, {6.0, 5.0, 4.0}, cone}};
  return scene;
}

// Towards the middle of the cloud, across the view.
const glm::dvec3 towards_cloud(-0.9, -1.4, -0.6);
const light::Spot smooth{towards_cloud, 5.0, 20.0};
const light::Spot sharp{{-0.9, -1.2, -0.7}, 11.8, 12.0};
const light::Spot wide{{-0.2, 1.0, 0.1}, 60.0, 130.0};

// The integral of the radiance that a ray of the camera scatters, by small steps.
double integral(const Scene& scene, const glm::dvec3& w, double begin, double end) {
  const Light& light = scene.lights[0];
  const light::Spot& cone = *light.as<light::Spot>();
  const double dark = std::cos(glm::radians(cone.outer_angle));
  const double slope = std::max(std::cos(glm::radians(cone.inner_angle)) - dark, 1e-9);
  return plain_airlight(scene, w, begin, end, 16000, [&](const glm::dvec3& x) {
    const glm::dvec3 q = x - light.position;
    const double r = glm::length(q);
    const double cosine = glm::dot(q / r, glm::normalize(cone.direction));
    const double share = std::clamp((cosine - dark) / slope, 0.0, 1.0);
    if (share == 0.0) return 0.0;
    const double depth = scene.medium.homogeneous_density() * r +
                         plain_depth(scene.medium, light.position, q / r, r);
    return light.intensity.x * share * share * std::exp(-depth) / (r * r);
  });
}

TEST(SpotLight, ReferenceIsTheIntegral) {
  for (const light::Spot& cone : {smooth, sharp, wide}) {
    Scene scene = in_fog(lit_by_spot(cone), 0.05);
    const Frame frame = render_frame(scene, reference_settings());
    expect_airlight(scene, frame, {{16, 12}, {13, 9}, {18, 6}, {20, 14}}, [&](const glm::dvec3& w) {
      return integral(scene, w, 0.0, 8.0) + integral(scene, w, 8.0, 100.0);
    });
  }
}

TEST(SpotLight, SlicedMatchesTheReference) {
  for (const light::Spot& cone : {smooth, sharp, wide}) {
    for (const double depth : {0.3, 3.0}) {
      for (const double b0 : {0.0, 0.05}) {
        Scene scene = in_fog(on_film(lit_by_spot(cone, depth), {16, 12}), b0);
        EXPECT_LT(airlight_error(scene, sliced(24), reference_settings()), 0.01)
            << cone.outer_angle << " depth " << depth << " b0 " << b0;
      }
    }
  }
}

// The lights of a street stand a few centimetres off some rays: slices span wide angles at them,
// over which cones and peaks of the phase function pass.
TEST(SpotLight, LightsBesideRaysMatchTheReference) {
  Scene scene = seen_by({{1.0, 1.7, 22.0}, {0.0, 3.0, -10.0}, {0.0, 1.0, 0.0}, 55.0}, {12, 9});
  scene.medium.set_homogeneous_density(0.03);
  const light::Spot downwards{{0.1, -1.0, 0.0}, 30.0, 70.0};
  light::Disk disk{.direction = {0.1, -1.0, 0.0}};
  disk.radius = 0.01;  // as good as a point
  for (const Light::Kind& kind :
       {Light::Kind(light::Point()), Light::Kind(downwards), Light::Kind(disk)}) {
    scene.lights.clear();
    for (const double z : {12.0, -2.0, -16.0}) {
      scene.lights.push_back({{z == -2.0 ? -5.0 : 5.0, 5.5, z}, glm::dvec3(80.0), kind});
    }
    for (const double g : {-0.7, 0.0, 0.5, 0.9}) {
      scene.optics.anisotropy = g;
      const Frame truth = render_frame(scene, reference_settings(1e-4));
      for (const auto& [slices, bound] : {std::pair(24, 0.015), {8, 0.05}}) {
        const Frame frame = render_frame(scene, sliced(slices));
        EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), bound) << g;
      }
    }
  }
}

// Soft and hard edges; the film is the ray through the beam's axis. Within a slice the density is
// the mean, so it takes many of them.
TEST(SpotLight, NarrowBeamsAreTheIntegral) {
  for (const auto& [inner, outer] :
       {std::pair{2.9, 3.0}, {1.5, 1.9}, {0.5, 1.0}, {1.0, 1.0}, {0.02, 0.05}}) {
    Scene scene = on_film(lit_by_spot({towards_cloud, inner, outer}), {1, 1});
    scene.camera.vertical_fov = 0.01;
    const double distance = glm::length(scene.camera.target - scene.camera.eye);
    const double half_width = 0.1 * outer;
    const double expected = integral(scene, glm::normalize(scene.camera.target - scene.camera.eye),
                                     distance - half_width, distance + half_width);
    for (const auto& [settings, bound] :
         {std::pair(reference_settings(), 1e-3), {sliced(128), 0.02}}) {
      EXPECT_NEAR(render_frame(scene, settings).airlight[0], expected, bound * expected)
          << inner << " to " << outer;
    }
  }
}

// A white wall 10 u away is as bright on the axis, whatever the cone: I / (pi d^2).
TEST(SpotLight, NarrowSpotsAreFullOnTheirAxis) {
  for (const auto& [inner, outer] : {std::pair{20.0, 30.0},
                                     {2.9, 3.0},
                                     {1.5, 1.9},
                                     {0.5, 1.0},
                                     {0.4, 0.5},
                                     {0.3, 0.3},
                                     {0.02, 0.05}}) {
    Scene scene = seen_by({{0.0, 0.0, 9.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.001}, {1, 1});
    scene.surfaces = {wall(0.0, 10.0, 1.0)};
    scene.lights = {
        {{0.0, 0.0, 10.0}, glm::dvec3(1000.0), light::Spot{{0.0, 0.0, -1.0}, inner, outer}}};
    for (const Settings& settings : {sliced(24), reference_settings(), path_traced(4)}) {
      EXPECT_NEAR(render_frame(scene, settings).beauty[0], 10.0 / std::numbers::pi, 1e-3)
          << inner << " to " << outer;
    }
  }
}

TEST(SpotLight, OfAllDirectionsIsAPointLight) {
  const Scene spot = lit_by_spot({smooth.direction, 179.999, 180.0});
  Scene point = spot;
  point.lights[0].kind = light::Point();
  for (const Settings& settings : {reference_settings(), sliced(24), all_orders(24)}) {
    EXPECT_LT(
        rel_rmse(render_frame(spot, settings).airlight, render_frame(point, settings).airlight),
        1e-4);
  }
}

TEST(SpotLight, AllOrdersMatchPaths) {
  for (const light::Spot& cone : {smooth, wide}) {
    Scene scene = on_film(lit_by_spot(cone, 3.0), {16, 12});
    scene.surfaces = {wall(-1.2, 1.5)};
    expect_all_orders_match_paths(scene, "to " + std::to_string(cone.outer_angle) + " degrees");
  }
}

// A narrow beam far away keeps its power on a coarse grid.
TEST(SpotLight, NarrowBeamsAreNotLostBetweenNodes) {
  Scene scene = on_film(cloud_scene(5, 2.0), {12, 9});
  scene.lights = {{{0.0, 40.0, 0.0}, glm::dvec3(4000.0), light::Spot{{0.0, -1.0, 0.0}, 0.05, 0.1}}};
  const double expected = mean_airlight(traced_truth(scene, 4096));
  EXPECT_NEAR(mean_airlight(scene, all_orders(24)), expected, 0.05 * expected);
}

// By the paper, nothing shines but isotropic point lights; what is left out is counted.
TEST(PaperLights, AreIsotropicPointsOnly) {
  const Light point{{0.0, 2.0, 0.0}, glm::dvec3(3.0), light::Point()};
  Light profile = point;
  *profile_member(profile) = cosine_profile();
  Scene scene = lit_by_spot(smooth);
  const Light spot = scene.lights[0];
  const Light sun{{}, glm::dvec3(1.0), light::Directional{{0.0, -1.0, 0.0}}};
  const Light area{{0.0, 2.0, 0.0}, glm::dvec3(3.0), light::Rectangle()};
  // Far away it is one point.
  const Light ball{{16.0, 12.0, 9.0}, glm::dvec3(90.0), light::Sphere()};
  scene.lights = {point};
  const Frame expected = render_frame(scene, paper_settings);
  const std::string left_out = "isotropic point lights only; left out: ";
  EXPECT_FALSE(is_left_out(expected, left_out));
  scene.lights = {spot, profile, sun, area, ball, point};
  const Frame all = render_frame(scene, paper_settings);
  EXPECT_TRUE(is_left_out(all, left_out + "5"));
  EXPECT_EQ(all.airlight, expected.airlight);
  scene.lights = {spot, profile, sun, area, ball};
  EXPECT_EQ(std::ranges::max(render_frame(scene, paper_settings).airlight), 0.0f);
}

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
double integral_of_sun(const Scene& scene, const glm::dvec3& w, double end) {
  const glm::dvec3 to_light = -glm::normalize(scene.lights[0].as<light::Directional>()->direction);
  const FogBall fog = FogExtent(scene).ball();
  const double b0 = scene.medium.homogeneous_density();
  return plain_airlight(scene, w, 0.0, end, 32000, [&](const glm::dvec3& x) {
    double depth = plain_depth(scene.medium, x, to_light, 1e3);
    if (b0 > 0.0) depth += b0 * fog.length(x, to_light);
    return scene.lights[0].intensity.x * std::exp(-depth);
  });
}

TEST(DirectionalLight, ReferenceIsTheIntegral) {
  for (const double b0 : {0.0, 0.05}) {
    Scene scene = in_fog(lit_by_sun(), b0);
    const Frame frame = render_frame(scene, reference_settings());
    const double end = b0 > 0.0 ? FogExtent(scene).ray_distance(scene.camera.eye) : 10.0;
    expect_airlight(scene, frame, {{16, 12}, {13, 9}, {18, 6}, {2, 2}},
                    [&](const glm::dvec3& w) { return integral_of_sun(scene, w, end); });
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
