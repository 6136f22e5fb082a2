// Area lights, as every method sees them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/area_lights.h"
#include "core/scene/lights/point_lights.h"
#include "render/reference/reference_pixels.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

enum class Shape { rectangle, disk, sphere };

constexpr double disk_radiance = 12.0;

Light area_light(Shape shape, const glm::dvec3& position, double size, bool two_sided = false) {
  const glm::dvec3 direction = -position + glm::dvec3(0.2, 0.0, 0.1);
  Light light{.position = position, .intensity = glm::dvec3(disk_radiance)};
  switch (shape) {
    case Shape::rectangle:
      light.kind = light::Rectangle{
          .direction = direction, .width = size, .height = 0.7 * size, .two_sided = two_sided};
      break;
    case Shape::disk:
      light.kind = light::Disk{direction, 0.5 * size, two_sided};
      break;
    case Shape::sphere:
      light.kind = light::Sphere{0.5 * size, two_sided};
      break;
  }
  return light;
}

void set_direction(Light& light, const glm::dvec3& direction) {
  if (auto* value = find_value<glm::dvec3>(light, "direction")) *value = direction;
}

void set_two_sided(Light& light, bool two_sided) {
  *find_value<bool>(light, "two_sided") = two_sided;
}

Scene lit_by(const Light& light, double depth = 1.0) {
  Scene scene = on_film(cloud_scene(12, depth), {32, 24});
  scene.lights = {light};
  return scene;
}

float brightest(const Frame& frame) {
  return *std::ranges::max_element(frame.airlight);
}

// Points of a surface, normals and areas: a fine grid of it.
struct Patch {
  glm::dvec3 position, normal;
  double area;
};
std::vector<Patch> patches(const Light& light, int count) {
  using std::numbers::pi;
  const auto* direction = find_value<glm::dvec3>(light, "direction");
  const glm::dvec3 n = direction ? glm::normalize(*direction) : glm::dvec3(0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(n, glm::dvec3(0.0, 1.0, 0.0)));
  const glm::dvec3 up = glm::cross(right, n);
  const double share = surface_area(*area_of(light)) / (count * count);
  std::vector<Patch> all;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k) {
      const double x = (i + 0.5) / count;
      const double y = (k + 0.5) / count;
      const double turn = 2.0 * pi * y;
      if (const auto* r = light.as<light::Rectangle>()) {
        all.push_back(
            {light.position + (x - 0.5) * r->width * right + (y - 0.5) * r->height * up, n, share});
      } else if (const auto* disk = light.as<light::Disk>()) {
        const double r_disk = disk->radius * std::sqrt(x);
        all.push_back(
            {light.position + r_disk * (std::cos(turn) * right + std::sin(turn) * up), n, share});
      } else {
        const double z = 2.0 * x - 1.0;
        const double sine = std::sqrt(1.0 - z * z);
        const glm::dvec3 normal(sine * std::cos(turn), sine * std::sin(turn), z);
        const double radius = std::get<light::Sphere>(light.kind).radius;
        all.push_back({light.position + radius * normal, normal, share});
      }
    }
  }
  return all;
}

// The sum over a surface at x: of radiance * cosine / r^2 * transmittance, times `facing` of the
// direction to it.
template <class Facing>
double arriving(const Scene& scene, const std::vector<Patch>& surface, const glm::dvec3& x,
                Facing facing) {
  const bool two_sided = is_two_sided(*area_of(scene.lights[0]));
  double sum = 0.0;
  for (const Patch& patch : surface) {
    const glm::dvec3 q = patch.position - x;
    const double r = glm::length(q);
    const double cosine = -glm::dot(q, patch.normal) / r;
    const double share = (two_sided ? std::abs(cosine) : std::max(cosine, 0.0)) * patch.area;
    if (!(share > 0.0)) continue;
    const double depth = plain_depth(scene.medium, x, q / r, r);
    sum +=
        facing(q / r) * share / (r * r) * std::exp(-depth - scene.medium.homogeneous_density() * r);
  }
  return scene.lights[0].intensity.x * sum;
}

// The reference at pixels of a frame of 32 x 24, against steps of its rays.
void expect_integral(const Scene& scene, int surface_points, double reference_tolerance,
                     const std::vector<glm::ivec2>& pixels, double bound) {
  const std::vector<Patch> surface = patches(scene.lights[0], surface_points);
  const CameraRays rays(scene.camera, scene.film);
  const ReferencePixels reference(scene, scene.camera, scene.film, reference_tolerance);
  for (const glm::ivec2 pixel : pixels) {
    const glm::dvec3 w = glm::normalize(rays.direction(pixel.x + 0.5, pixel.y + 0.5));
    const double expected = plain_airlight(scene, w, 0.0, 10.0, 500, [&](const glm::dvec3& x) {
      return arriving(scene, surface, x, [](const glm::dvec3&) { return 1.0; });
    });
    const std::array at{static_cast<std::size_t>(pixel.y * scene.film.width + pixel.x)};
    EXPECT_NEAR(reference.airlight(at, {})[0].x, expected, bound * expected + 1e-7)
        << kind_info(scene.lights[0]).name << " at " << pixel.x << ", " << pixel.y;
  }
}

TEST(AreaLight, ReferenceIsTheIntegral) {
  for (const Shape shape : {Shape::rectangle, Shape::disk, Shape::sphere}) {
    for (const double size : {0.4, 1.5}) {
      const Scene scene = lit_by(area_light(shape, {1.6, 1.2, 0.9}, size, shape == Shape::disk));
      expect_integral(scene, 24, 1e-5, {{16, 12}, {13, 9}, {20, 6}}, 3e-3);
    }
  }
}

TEST(AreaLight, SlicedMatchesTheReference) {
  for (const Shape shape : {Shape::rectangle, Shape::disk, Shape::sphere}) {
    for (const bool two_sided : {false, true}) {
      Scene scene =
          on_film(lit_by(area_light(shape, {1.6, 1.2, 0.9}, 0.8, two_sided), 2.0), {8, 6});
      const Frame truth = render_frame(scene, reference_settings(1e-3));
      EXPECT_LT(rel_rmse(render_frame(scene, sliced(24)).airlight, truth.airlight), 0.01)
          << kind_info(scene.lights[0]).name << " sides " << 1 + two_sided;
    }
  }
}

// Pixels that see fog nearer to the light than its points are to one another err most; the points
// of a sphere, half of which face away, are the farthest apart.
TEST(AreaLight, SlicedMatchesTheReferenceInFog) {
  for (const Shape shape : {Shape::rectangle, Shape::disk, Shape::sphere}) {
    Scene scene =
        in_fog(on_film(lit_by(area_light(shape, {1.6, 1.2, 0.9}, 0.8), 2.0), {8, 6}), 0.05);
    const double bound = shape == Shape::sphere ? 0.1 : 0.02;
    EXPECT_LT(airlight_error(scene, sliced(24), reference_settings(1e-3)), bound)
        << kind_info(scene.lights[0]).name;
  }
}

// View rays that pass next to it as well.
TEST(AreaLight, ReferenceIsTheIntegralAroundALightInTheMedium) {
  for (const Shape shape : {Shape::rectangle, Shape::sphere}) {
    const Scene scene = lit_by(area_light(shape, {0.1, 0.05, 0.1}, 0.5));
    expect_integral(scene, 40, 1e-4, {{13, 9}, {20, 6}, {14, 12}}, 5e-3);
  }
}

TEST(AreaLight, LightsAWallAsInClosedForm) {
  // A wall facing a coaxial disk, E = pi L r^2 / (r^2 + d^2), and a sphere, E = pi L r^2 / d^2.
  constexpr double r = 0.3;
  constexpr double d = 1.2;
  for (const Shape shape : {Shape::disk, Shape::sphere}) {
    Scene scene = seen_by({{0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5}, {9, 9});
    scene.surfaces = {wall(0.0, 1.0)};
    scene.lights = {area_light(shape, {0.0, 0.0, d}, 2.0 * r)};
    set_direction(scene.lights[0], {0.0, 0.0, -1.0});
    const double square = shape == Shape::disk ? r * r + d * d : d * d;
    const double expected = 0.5 * disk_radiance * r * r / square;  // albedo 0.5
    for (const auto& [settings, bound] :
         {std::pair(sliced(24), 0.01), {reference_settings(), 2e-3}, {path_traced(64), 0.02}}) {
      const Frame frame = render_frame(scene, settings);
      EXPECT_NEAR(frame.beauty[3 * 40], expected, bound * expected)
          << kind_info(scene.lights[0]).name;
    }
  }
}

// A floor 1 cm below a ball and 5 cm below a panel: E = pi L r^2 h / d^3 of a sphere whose center
// is h above it and d away, and the panel by its closed form over four corners. A pixel's noise is
// an eighth of what it sees, or less; bright dots of single points would be off by half.
TEST(AreaLight, PathsLightAFloorNextToItAsInClosedForm) {
  Scene scene = seen_by({{0.0, 0.0, 4.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 30.0}, {15, 15});
  scene.surfaces = {wall(0.0, 10.0, 1.0)};
  const auto expect_radiance = [&scene](auto radiance) {
    const Frame frame = render_frame(scene, path_traced(256));
    const CameraRays rays(scene.camera, scene.film);
    double sum = 0.0;
    double expected_sum = 0.0;
    for (int pixel = 0; pixel < 15 * 15; ++pixel) {
      const glm::dvec3 w = rays.direction(pixel % 15 + 0.5, pixel / 15 + 0.5);
      const glm::dvec3 x = scene.camera.eye - scene.camera.eye.z / w.z * w;
      const double expected = radiance(x);
      const double found = frame.beauty[4 * static_cast<std::size_t>(pixel)];
      EXPECT_NEAR(found, expected, 0.3 * expected) << x.x << ", " << x.y;
      sum += found;
      expected_sum += expected;
    }
    EXPECT_NEAR(sum, expected_sum, 0.01 * expected_sum);
  };

  constexpr double radius = 0.5;
  constexpr double height = 0.51;
  scene.lights = {area_light(Shape::sphere, {0.0, 0.0, height}, 2.0 * radius)};
  expect_radiance([](const glm::dvec3& x) {
    const double distance = glm::length(glm::dvec3(x.x, x.y, height));
    return disk_radiance * radius * radius * height / std::pow(distance, 3.0);
  });

  constexpr double gap = 0.05;
  scene.lights = {area_light(Shape::rectangle, {0.0, 0.0, gap}, 1.0)};
  set_direction(scene.lights[0], {0.0, 0.0, -1.0});
  scene.lights[0].as<light::Rectangle>()->height = 1.0;
  expect_radiance([](const glm::dvec3& x) {
    // The form factor of a parallel rectangle from below its corner.
    const auto corner = [](double u, double v) {
      const double a = std::hypot(u, gap);
      const double b = std::hypot(v, gap);
      return (u / a * std::atan(v / a) + v / b * std::atan(u / b)) / (2.0 * std::numbers::pi);
    };
    return disk_radiance * (corner(0.5 - x.x, 0.5 - x.y) + corner(0.5 + x.x, 0.5 - x.y) +
                            corner(0.5 - x.x, 0.5 + x.y) + corner(0.5 + x.x, 0.5 + x.y));
  });
}

// Scattered once and more often, seen by paths that know nothing of slices and grids.
TEST(AreaLight, AllOrdersMatchPaths) {
  Scene scene = on_film(lit_by(area_light(Shape::rectangle, {1.6, 1.2, 0.9}, 0.8), 3.0), {16, 12});
  expect_all_orders_match_paths(scene, "rectangle");
}

TEST(AreaLight, FarAwayASphereIsAPoint) {
  Scene scene = lit_by(area_light(Shape::sphere, {16.0, 12.0, 9.0}, 1.0));
  const Frame sphere = render_frame(scene, sliced(24));
  EXPECT_EQ(point_lights(scene, LightPoints::few).size(), 1u);
  scene.lights[0].intensity *= facing_area(*area_of(scene.lights[0]));
  scene.lights[0].kind = light::Point();
  const Frame point = render_frame(scene, sliced(24));
  EXPECT_LT(rel_rmse(sphere.airlight, point.airlight), 1e-6);
  // And the point is what many points of its surface add up to.
  scene.lights = {area_light(Shape::sphere, {16.0, 12.0, 9.0}, 1.0)};
  scene.surfaces = {wall(-50.0, 0.1)};  // where there are shadows it takes more
  EXPECT_EQ(point_lights(scene, LightPoints::few).size(), 13u);
  const Frame many = render_frame(scene, sliced(24));
  EXPECT_LT(rel_rmse(many.airlight, point.airlight), 1e-3);
}

// From within a sphere that shines inwards all directions are alike.
TEST(AreaLight, AroundTheSceneASphereIsAnEnvironment) {
  Scene scene = lit_by(area_light(Shape::sphere, {0.0, 0.0, 0.0}, 40.0, true), 0.01);
  const Frame frame = render_frame(scene, sliced(24));
  const CameraRays rays(scene.camera, scene.film);
  const glm::dvec3 w = glm::normalize(rays.direction(16.5, 12.5));
  const double expected =
      disk_radiance * -std::expm1(-plain_depth(scene.medium, scene.camera.eye, w, 20.0));
  EXPECT_NEAR(frame.airlight[3 * (12 * 32 + 16)], expected, 0.02 * expected);
  set_two_sided(scene.lights[0], false);
  const Frame dark = render_frame(scene, sliced(24));
  EXPECT_EQ(brightest(dark), 0.0f);
}

TEST(AreaLight, OneSideShinesAndTwoDo) {
  Scene scene = lit_by(area_light(Shape::disk, {1.6, 1.2, 0.9}, 0.8));
  const Frame front = render_frame(scene, sliced(24));
  set_two_sided(scene.lights[0], true);
  EXPECT_LT(rel_rmse(render_frame(scene, sliced(24)).airlight, front.airlight), 1e-6);
  set_direction(scene.lights[0], -std::get<light::Disk>(scene.lights[0].kind).direction);
  EXPECT_LT(rel_rmse(render_frame(scene, sliced(24)).airlight, front.airlight), 0.01);
  set_two_sided(scene.lights[0], false);
  EXPECT_EQ(brightest(render_frame(scene, sliced(24))), 0.0f);
}

// A panel and a ball next to a floor, without fog.
Scene light_at_a_floor(const Light& light) {
  Scene scene =
      seen_by({.eye = {0.0, 3.0, 4.0}, .target = {0.0, 0.0, 0.0}, .vertical_fov = 30.0}, {32, 24});
  scene.surfaces = {placed(Primitive::Shape::plane, {20.0, 1.0, 20.0}, {0.0, 0.0, 0.0})};
  scene.surfaces[0].material.reflectance = glm::dvec3(1.0);
  scene.lights = {light};
  return scene;
}

TEST(AreaLights, DoNotShowTheirPointsAtAFloor) {
  Light panel{.position = {0.0, 0.05, 0.0}, .intensity = glm::dvec3(1.0)};
  panel.kind = light::Rectangle{.direction = {0, -1, 0}, .up = {0, 0, 1}, .width = 1, .height = 1};
  Light ball{.position = {0.0, 0.51, 0.0}, .intensity = glm::dvec3(1.0)};
  ball.kind = light::Sphere{0.5, false};
  for (const Light& light : {panel, ball}) {
    const Scene scene = light_at_a_floor(light);
    const Frame frame = render_frame(scene, sliced(8));
    const CameraRays rays(scene.camera, scene.film);
    for (int y = 0; y < scene.film.height; ++y) {
      for (int x = 0; x < scene.film.width; ++x) {
        const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
        const glm::dvec3 floor = scene.camera.eye - scene.camera.eye.y / w.y * w;
        const double expected =
            area_irradiance(*area_of(light), light.position, floor, {0, 1, 0}) / std::numbers::pi;
        const auto i = 4 * static_cast<std::size_t>(y * scene.film.width + x);
        EXPECT_NEAR(frame.beauty[i], expected, 2e-3 * expected + 1e-5) << x << " " << y;
      }
    }
  }
}

// On smooth metal, where the points of the light would be seen one by one.
TEST(AreaLights, ShineOnMetalAsPathsHaveThem) {
  for (const double roughness : {0.3, 0.6}) {
    Light panel{.position = {0.0, 0.8, -1.0}, .intensity = {5.0, 4.0, 3.0}};
    panel.kind = light::Rectangle{
        .direction = {0.0, -1.0, 0.6}, .up = {0, 0, 1}, .width = 1.2, .height = 0.6};
    Scene scene = light_at_a_floor(panel);
    scene.camera.eye.y = 1.6;
    scene.camera.vertical_fov = 40.0;
    scene.surfaces[0].material = metallic_roughness(glm::dvec3(0.7), 1.0, roughness);
    const Frame frame = render_frame(scene, sliced(8));
    const Frame truth = render_frame(scene, path_traced(256));
    // Blocks of 8 x 8: a path's pixel is a mean over its square.
    constexpr int side = 8;
    double difference = 0.0;
    double sum = 0.0;
    for (int block = 0; block < 12; ++block) {
      double mean = 0.0;
      double true_mean = 0.0;
      for (int k = 0; k < side * side; ++k) {
        const int x = block % 4 * side + k % side;
        const int y = block / 4 * side + k / side;
        const auto i = 4 * static_cast<std::size_t>(y * scene.film.width + x);
        mean += static_cast<double>(frame.beauty[i]);
        true_mean += static_cast<double>(truth.beauty[i]);
      }
      difference += std::abs(mean - true_mean);
      sum += true_mean;
    }
    EXPECT_LT(difference / sum, 0.04) << roughness;
  }
}

}  // namespace
}  // namespace brume
