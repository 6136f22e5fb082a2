#include "core/scene/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace brume {

CameraRays::CameraRays(const Camera& camera, const Film& film)
    : eye_(camera.eye), size_(film.width, film.height) {
  const glm::dvec3 view = camera.target - camera.eye;
  const double distance = glm::length(view);
  forward_ = distance > 0.0 ? view / distance : glm::dvec3(0.0, 0.0, -1.0);
  glm::dvec3 right = glm::cross(forward_, camera.up);
  if (glm::dot(right, right) <= 1e-24 * glm::dot(camera.up, camera.up)) {
    // `up` along the view says nothing; any axis across the view will do.
    const glm::dvec3 other = std::abs(forward_.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    right = glm::cross(forward_, other);
  }
  right_ = glm::normalize(right);
  up_ = glm::cross(right_, forward_);
  half_size_.y = std::tan(0.5 * glm::radians(camera.vertical_fov));
  half_size_.x = half_size_.y * size_.x / size_.y;
}

glm::dvec3 CameraRays::direction(double x, double y) const {
  const double u = (2.0 * x / size_.x - 1.0) * half_size_.x;
  const double v = (1.0 - 2.0 * y / size_.y) * half_size_.y;
  return glm::normalize(forward_ + u * right_ + v * up_);
}

glm::dvec3 CameraRays::project(const glm::dvec3& point) const {
  const glm::dvec3 q = point - eye_;
  const double z = glm::dot(q, forward_);
  if (!(z > 0.0)) return {0.0, 0.0, z};
  const double u = glm::dot(q, right_) / (z * half_size_.x);
  const double v = glm::dot(q, up_) / (z * half_size_.y);
  return {0.5 * (u + 1.0) * size_.x, 0.5 * (1.0 - v) * size_.y, z};
}

double CameraRays::pixel_half_angle() const { return std::atan(half_size_.y / size_.y); }

}  // namespace brume
