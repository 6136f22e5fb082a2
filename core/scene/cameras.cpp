#include "core/scene/cameras.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "core/number_domain.h"

namespace brume {
namespace {

double sensor_height(const Film& film) {
  return sensor_width * film.height / film.width;
}

}  // namespace

std::optional<RefusedMember> refusal(const Camera& camera) {
  if (!(glm::length(camera.target - camera.eye) > 0.0)) {
    return RefusedMember{"target", "found the position of the eye; allowed: any other point"};
  }
  if (!(glm::length(camera.up) > 0.0)) {
    return RefusedMember{"up", "found a vector of length 0; allowed: any other"};
  }
  return std::nullopt;
}

NamedCamera camera_in_use(const Scene& scene) {
  return {scene.camera_name, scene.camera, scene.camera_keys, scene.camera_id};
}

bool use_camera(Scene& scene, std::string_view name) {
  if (name == scene.camera_name) return true;
  const auto found = std::ranges::find(scene.cameras, name, &NamedCamera::name);
  if (found == scene.cameras.end()) return false;
  NamedCamera camera = std::exchange(*found, camera_in_use(scene));
  scene.camera_name = std::move(camera.name);
  scene.camera = camera.camera;
  scene.camera_keys = std::move(camera.keys);
  scene.camera_id = camera.id;
  return true;
}

std::string free_camera_name(const Scene& scene, const std::string& wanted) {
  const auto is_taken = [&scene](const std::string& name) {
    return name == scene.camera_name ||
           std::ranges::find(scene.cameras, name, &NamedCamera::name) != scene.cameras.end();
  };
  std::string name = wanted;
  for (int k = 2; is_taken(name); ++k) name = wanted + ' ' + std::to_string(k);
  return name;
}

double half_height(const Camera& camera) {
  if (camera.height) return 0.5 * *camera.height;
  return glm::distance(camera.eye, camera.target) *
         std::tan(0.5 * glm::radians(camera.vertical_fov));
}

Camera orthographic(const Camera& camera) {
  Camera result = camera;
  result.height = domain::length.nearest(2.0 * half_height(camera));
  // Values that do not count are as in a file, which has neither.
  result.vertical_fov = Camera().vertical_fov;
  result.aperture = Camera().aperture;
  return result;
}

Camera perspective(const Camera& camera) {
  Camera result = camera;
  const double slope = half_height(camera) / glm::distance(camera.eye, camera.target);
  result.vertical_fov = domain::field_of_view.nearest(2.0 * glm::degrees(std::atan(slope)));
  result.height.reset();
  return result;
}

double focal_length(double vertical_fov, const Film& film) {
  return 0.5 * sensor_height(film) / std::tan(0.5 * glm::radians(vertical_fov));
}

double vertical_fov(double focal_length, const Film& film) {
  return 2.0 * glm::degrees(std::atan(0.5 * sensor_height(film) / focal_length));
}

}  // namespace brume
