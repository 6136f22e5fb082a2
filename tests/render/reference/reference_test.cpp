#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/camera_rays.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// An independent integrator: densities summed point by point, everything by the midpoint rule, no
// closed form, no culling. Slow, and as simple as the integral itself.
class Marching {
 public:
  explicit Marching(const Scene& scene, int light_steps = 300)
      : scene_(scene), light_steps_(light_steps) {}

  // Whether the straight way between two points is free; for scenes with surfaces.
  std::function<bool(const glm::dvec3&, const glm::dvec3&)> free = [](auto&, auto&) {
    return true;
  };

  [[nodiscard]] double density(const glm::dvec3& x) const {
    double sum = scene_.medium.homogeneous_density();
    for (std::size_t i = 0; i < scene_.medium.size(); ++i) {
      const glm::dvec3 q = (x - scene_.medium.centers()[i]) / scene_.medium.radii()[i];
      sum += scene_.medium.densities()[i] * std::exp(-glm::dot(q, q));
    }
    return sum;
  }

  [[nodiscard]] double depth(const glm::dvec3& a, const glm::dvec3& b, int steps) const {
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) sum += density(a + (k + 0.5) / steps * (b - a));
    return sum * glm::length(b - a) / steps;
  }

  // Airlight of the first light, per unit of intensity, along [0, length].
  [[nodiscard]] double airlight(const glm::dvec3& eye, const glm::dvec3& w, double length,
                                int steps) const {
    const glm::dvec3 light = scene_.lights[0].position;
    const double dt = length / steps;
    double view_depth = 0.0;
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
      const glm::dvec3 x = eye + (k + 0.5) * dt * w;
      const double b = density(x);
      view_depth += 0.5 * b * dt;
      if (free(light, x)) {
        const glm::dvec3 q = light - x;
        // Henyey and Greenstein's formula as they wrote it, with the angle between the way of the
        // light and the way to the eye.
        const double g = scene_.optics.anisotropy;
        const double cosine = glm::dot(glm::normalize(-q), -w);
        const double phase = (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
        sum += phase * b * std::exp(-view_depth - depth(light, x, light_steps_)) / glm::dot(q, q);
      }
      view_depth += 0.5 * b * dt;
    }
    return sum * dt / (4.0 * std::numbers::pi);
  }

 private:
  const Scene& scene_;
  int light_steps_;
};

// relRMSE of the reference's airlight over all pixels against marching up to `length`.
double error_against_marching(const Scene& scene, const Marching& marching, double length,
                              int steps) {
  const Frame frame = render_frame(scene, reference_settings(1e-4));
  const CameraRays rays(scene.camera, scene.film);
  double square = 0.0;
  double square_true = 0.0;
  for (int y = 0; y < scene.film.height; ++y) {
    for (int x = 0; x < scene.film.width; ++x) {
      const auto pixel = static_cast<std::size_t>(y * scene.film.width + x);
      const double end = std::min(length, static_cast<double>(frame.depth[pixel]));
      const double reference =
          scene.lights[0].intensity.x *
          marching.airlight(rays.eye(), rays.direction(x + 0.5, y + 0.5), end, steps);
      const double d = static_cast<double>(frame.airlight[3 * pixel]) - reference;
      square += d * d;
      square_true += reference * reference;
    }
  }
  return std::sqrt(square / square_true);
}

TEST(Reference, AgreesWithMarchingThroughAClump) {
  Scene scene = on_film(cloud_scene(12, 2.5, 5), {7, 7});
  EXPECT_LT(error_against_marching(scene, Marching(scene), 7.0, 700), 3e-4);
}

TEST(Reference, AgreesWithMarchingInFogWithTheLightInView) {
  Scene scene = in_fog(cloud_scene(6, 1.0, 6), 0.1);
  scene.lights[0].position = {0.35, 0.2, 0.3};
  scene.camera.eye = {0.1, 0.1, 2.0};
  scene.film = {4, 4};
  // Every ray ends at a wall: marching cannot go to infinity.
  scene.surfaces.push_back(wall(-8.0, 100.0));
  EXPECT_LT(error_against_marching(scene, Marching(scene), 12.0, 3000), 5e-4);
}

// Extinction is scattering / albedo, per colour channel.
TEST(Reference, AgreesWithMarchingWhenTheMediumAbsorbs) {
  Scene scene = on_film(cloud_scene(8, 1.5, 4), {6, 6});
  scene.optics.albedo = {0.5, 1.0, 0.8};
  const Frame frame = render_frame(scene, reference_settings(1e-4));
  const CameraRays rays(scene.camera, scene.film);
  for (const int c : {0, 1, 2}) {
    // Marching knows no albedo: it sees the extinction, of which the albedo is scattered.
    const double albedo = scene.optics.albedo[c];
    Scene extinction = scene;
    extinction.medium = Medium();
    for (std::size_t i = 0; i < scene.medium.size(); ++i) {
      Gaussian g = scene.medium.gaussian(i);
      g.density /= albedo;
      extinction.medium.append(g);
    }
    const Marching marching(extinction);
    for (const int i : {7, 14, 15, 20, 28}) {
      const glm::dvec3 w = rays.direction(i % 6 + 0.5, i / 6 + 0.5);
      const double reference =
          albedo * scene.lights[0].intensity[c] * marching.airlight(rays.eye(), w, 7.0, 700);
      const auto at = static_cast<std::size_t>(3 * i + c);
      EXPECT_NEAR(frame.airlight[at], reference, 1e-3 * reference);
      EXPECT_NEAR(frame.transmittance[at],
                  std::exp(-marching.depth(rays.eye(), rays.eye() + 8.0 * w, 2000)), 1e-4);
    }
  }
}

TEST(Reference, AgreesWithMarchingWhenScatteringIsAnisotropic) {
  for (const double g : {0.7, -0.4}) {
    Scene scene = in_fog(cloud_scene(8, 1.5, 4), 0.05);
    scene.optics.anisotropy = g;
    scene.lights[0].position = {0.7, 0.5, -1.5};
    scene.surfaces.push_back(wall(-2.5, 100.0));
    scene.film = {4, 4};
    EXPECT_LT(error_against_marching(scene, Marching(scene), 10.0, 2000), 5e-4) << g;
  }
}

// Light shafts: a wall between the light and half of the medium.
TEST(Reference, SurfacesBlockLightOnItsWayThroughTheMedium) {
  Scene scene = on_film(cloud_scene(10, 1.5, 7), {5, 5});
  scene.lights[0].position = {0.2, 0.1, -4.0};
  scene.surfaces.push_back(wall(-2.0, 0.3));
  Marching marching(scene, 100);
  const double open = error_against_marching(scene, marching, 7.0, 700);
  marching.free = [](const glm::dvec3& a, const glm::dvec3& b) {
    const double t = (-2.0 - a.z) / (b.z - a.z);
    if (!(t > 0.0 && t < 1.0)) return true;
    const glm::dvec3 x = a + t * (b - a);
    return std::max(std::abs(x.x), std::abs(x.y)) > 0.3;
  };
  // The midpoint rule is off by up to half a step at each edge of the shadow.
  EXPECT_LT(error_against_marching(scene, marching, 7.0, 6000), 1e-3);
  EXPECT_GT(open, 0.1) << "the wall must matter in this scene";
}

TEST(Reference, HalvingTheToleranceChangesNothing) {
  Scene scene = on_film(in_fog(cloud_scene(60, 3.0, 8), 0.02), {16, 16});
  scene.surfaces.push_back(wall(-0.3, 0.6));
  const Frame coarse = render_frame(scene, reference_settings(1e-4));
  const Frame fine = render_frame(scene, reference_settings(0.5e-4));
  EXPECT_LT(rel_rmse(coarse.beauty, fine.beauty), 1e-4);
}

// Forty thin slats between light and medium: no probe of shadow rays would find all their edges.
TEST(Reference, HalvingTheToleranceChangesNothingBehindAFence) {
  Scene scene = on_film(cloud_scene(20, 1.0, 9), {9, 9});
  scene.lights[0].position = {0.0, 4.0, 0.5};
  for (int i = 0; i < 40; ++i) {
    Surface slat = wall(0.0, 1.0);
    slat.scale = 0.02;
    slat.rotate = glm::dquat(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
    slat.translate = {-1.2 + 0.06 * i, 2.0, 0.0};
    scene.surfaces.push_back(slat);
  }
  const Frame coarse = render_frame(scene, reference_settings(1e-4));
  const Frame fine = render_frame(scene, reference_settings(0.5e-4));
  EXPECT_LT(rel_rmse(coarse.beauty, fine.beauty), 1e-4);
  // And the shafts are right: marching with the fence's own formula.
  Marching marching(scene, 100);
  marching.free = [](const glm::dvec3& a, const glm::dvec3& b) {
    const double t = (2.0 - a.y) / (b.y - a.y);
    const glm::dvec3 x = a + t * (b - a);
    if (!(t > 0.0 && t < 1.0) || std::abs(x.z) > 0.02) return true;
    const double slat = (x.x + 1.2) / 0.06;
    return std::abs(slat - std::clamp(std::round(slat), 0.0, 39.0)) * 0.06 > 0.02;
  };
  EXPECT_LT(error_against_marching(scene, marching, 7.0, 2000), 2e-3);
}

// A needle in a haystack: a tiny dense Gaussian in broad haze, and the sharp shadow it casts.
TEST(Reference, FindsASmallGaussianAndItsShadow) {
  Scene scene = seen_by({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 20.0}, {5, 41});
  scene.lights.push_back({{0, 6, 0}, {1, 1, 1}, {}});
  scene.medium.append({{0, 0, 0}, 3.0, 0.05});
  scene.medium.append({{0, 1.5, 0.01}, 0.02, 200.0});
  const Marching marching(scene, 3000);
  const Frame frame = render_frame(scene, reference_settings(1e-4));
  const CameraRays rays(scene.camera, scene.film);
  for (const int y : {2, 30}) {
    const auto pixel = static_cast<std::size_t>(y * scene.film.width + 2);
    const double reference =
        marching.airlight(rays.eye(), rays.direction(2.5, y + 0.5), 15.0, 6000);
    EXPECT_NEAR(frame.airlight[3 * pixel], reference, 1e-3 * reference) << y;
  }
}

}  // namespace
}  // namespace brume
