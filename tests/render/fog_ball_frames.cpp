#include "tests/render/fog_ball_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/camera_rays.h"
#include "core/transport/phase_function.h"
#include "render/prepare/fog_extent.h"
#include "tests/render/test_scenes.h"

namespace brume {

Scene fog_ball_scene(const glm::dvec3& eye) {
  Scene scene;
  scene.medium.set_homogeneous_density(0.5);
  scene.optics.extent = 1.0;
  scene.camera = {eye, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 50.0};
  scene.film = {32, 24};
  return scene;
}

Scene fog_ball_between_walls() {
  Scene scene = fog_ball_scene();
  // Around the origin in the mean, where the ball is.
  for (const double side : {-1.0, 0.0, 1.0}) {
    Surface surface = wall(0.0, 0.35);
    surface.translate = {0.75 * side, 0.0, 1.5 * side};
    scene.surfaces.push_back(std::move(surface));
  }
  return scene;
}

FogBallRay fog_ray_of(const Scene& scene, const Frame& frame, std::size_t pixel) {
  const CameraRays rays(scene.camera, scene.film);
  const auto width = static_cast<std::size_t>(scene.film.width);
  const double x = static_cast<double>(pixel % width) + 0.5;
  const double y = static_cast<double>(pixel / width) + 0.5;
  FogBallRay ray{rays.origin(x, y), rays.direction(x, y)};
  const FogBall ball = FogExtent(scene).fog();
  const FogInterval in_ball = ball.interval(ray.origin, ray.w);
  ray.begin = in_ball.begin;
  ray.end = std::max(std::min(in_ball.end, static_cast<double>(frame.depth[pixel])), ray.begin);
  return ray;
}

double fog_transmittance(const Scene& scene, const Frame& frame, std::size_t pixel) {
  const FogBallRay ray = fog_ray_of(scene, frame, pixel);
  const double density = scene.medium.homogeneous_density() / scene.optics.albedo.x;
  return std::exp(-density * (ray.end - ray.begin));
}

double scattered_once(const Scene& scene, const Frame& frame, std::size_t pixel) {
  const FogBallRay ray = fog_ray_of(scene, frame, pixel);
  const FogBall ball = FogExtent(scene).fog();
  const double scattering = scene.medium.homogeneous_density();
  const double extinction = scattering / scene.optics.albedo.x;
  constexpr int steps = 400;
  const double step = (ray.end - ray.begin) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = ray.begin + step * (i + 0.5);
    const glm::dvec3 x = ray.origin + t * ray.w;
    for (const Light& light : scene.lights) {
      const auto* far = light.as<light::Directional>();
      const glm::dvec3 q = far ? -far->direction : light.position - x;
      const glm::dvec3 to_light = glm::normalize(q);
      const double length =
          far ? ball.length(x, to_light) : ball.length(x, to_light, glm::length(q));
      const double falloff = far ? 1.0 : 1.0 / glm::dot(q, q);
      sum += step * scattering * falloff * light.intensity.x *
             henyey_greenstein(glm::dot(-to_light, -ray.w), scene.optics.anisotropy) *
             std::exp(-extinction * (t - ray.begin + length));
    }
  }
  return sum / (4.0 * std::numbers::pi);
}

double scattered_once_error(const Scene& scene, const Frame& frame) {
  double squares = 0.0;
  double errors = 0.0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const double truth = scattered_once(scene, frame, i);
    const double error = static_cast<double>(frame.airlight[3 * i]) - truth;
    squares += truth * truth;
    errors += error * error;
  }
  return std::sqrt(errors / squares);
}

double fog_transmittance_error(const Scene& scene, const Frame& frame) {
  double most = 0.0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const double error =
        static_cast<double>(frame.transmittance[3 * i]) - fog_transmittance(scene, frame, i);
    most = std::max(most, std::abs(error));
  }
  return most;
}

}  // namespace brume
