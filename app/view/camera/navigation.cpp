#include "app/view/camera/navigation.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/number_domain.h"

namespace brume {

double target_distance(const Camera& camera) {
  return glm::distance(camera.eye, camera.target);
}

double viewing_distance(const CameraRays& rays, const glm::dvec3& point) {
  if (!rays.is_parallel()) return glm::distance(rays.eye(), point);
  return 0.5 * rays.pixel_width() * rays.whole_size().y /
         std::tan(0.5 * glm::radians(Camera{}.vertical_fov));
}

Camera orbit(const Camera& camera, const glm::dvec3& pivot, glm::dvec2 angles) {
  const glm::dvec3 offset = camera.eye - camera.target;
  const double distance = glm::length(offset);
  if (!(distance > 0.0)) return camera;
  const glm::dvec3 up = glm::normalize(camera.up);
  glm::dvec3 right = glm::cross(up, offset);
  if (glm::length(right) < 1e-9 * distance) {
    right = glm::cross(up, std::abs(up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
  }
  right = glm::normalize(right);
  // Stopping short of the poles keeps "up" meaningful.
  constexpr double margin = 0.02;
  const double polar = std::acos(std::clamp(glm::dot(offset, up) / distance, -1.0, 1.0));
  const double moved = std::clamp(polar - angles.y, margin, glm::radians(180.0) - margin);
  const glm::dquat turn = glm::angleAxis(-angles.x, up) * glm::angleAxis(moved - polar, right);
  Camera result = camera;
  for (glm::dvec3* point : {&result.eye, &result.target}) {
    *point = pivot + turn * (*point - pivot);
  }
  return result;
}

Camera fly(const Camera& camera, const glm::dvec3& way) {
  const CameraRays rays(camera, Film());
  const glm::dvec3 right = glm::cross(rays.forward(), rays.up());
  const glm::dvec3 shift = way.x * right + way.y * rays.up() + way.z * rays.forward();
  Camera result = camera;
  result.eye += shift;
  result.target += shift;
  return result;
}

Camera pan(const Camera& camera, const Film& film, glm::dvec2 pixels) {
  const CameraRays rays(camera, film);
  const double distance = std::max(target_distance(camera), 1e-12);
  const double cx = 0.5 * film.width;
  const double cy = 0.5 * film.height;
  const auto point_at = [&](double x, double y) {
    const glm::dvec3 direction = rays.direction(x, y);
    return rays.offset(x, y) + direction * (distance / glm::dot(direction, rays.forward()));
  };
  const glm::dvec3 shift = point_at(cx, cy) - point_at(cx + pixels.x, cy + pixels.y);
  Camera result = camera;
  result.eye += shift;
  result.target += shift;
  return result;
}

Camera zoom(const Camera& camera, double factor) {
  Camera result = camera;
  if (camera.height) {
    result.height = domain::length.nearest(factor * *camera.height);
    return result;
  }
  const glm::dvec3 offset = (camera.eye - camera.target) * factor;
  // Further in, the eye could no longer be told from the target.
  const double scale = std::max(
      {1.0, std::abs(camera.target.x), std::abs(camera.target.y), std::abs(camera.target.z)});
  if (glm::length(offset) > 1e-9 * scale) result.eye = camera.target + offset;
  return result;
}

Camera frame_sphere(const Camera& camera, const Film& film, const glm::dvec3& center,
                    double radius) {
  const CameraRays rays(camera, film);
  if (camera.height) {
    Camera result = camera;
    result.target = center;
    // The whole sphere is before the plane of the eye.
    result.eye = center - rays.forward() * std::max(target_distance(camera), 2.0 * radius);
    const double aspect = static_cast<double>(film.height) / film.width;
    result.height = domain::length.nearest(2.0 * radius * std::max(1.0, aspect));
    return result;
  }
  const double vertical = 0.5 * glm::radians(camera.vertical_fov);
  const double horizontal = std::atan(std::tan(vertical) * film.width / film.height);
  const double distance = radius / std::sin(std::min(vertical, horizontal));
  Camera result = camera;
  result.target = center;
  result.eye = center - rays.forward() * distance;
  return result;
}

std::optional<NavigationDrag> navigation_drag(NavigationPreset preset, Qt::MouseButton button,
                                              Qt::KeyboardModifiers modifiers) {
  using Drag = NavigationDrag;
  const bool alt = modifiers.testFlag(Qt::AltModifier);
  const bool shift = modifiers.testFlag(Qt::ShiftModifier);
  const bool control = modifiers.testFlag(Qt::ControlModifier);
  const bool middle = button == Qt::MiddleButton;
  switch (preset) {
    case NavigationPreset::brume:
      if (middle) return alt || shift ? Drag::pan : Drag::orbit;
      break;
    case NavigationPreset::blender:
      if (middle) return shift ? Drag::pan : control ? Drag::zoom : Drag::orbit;
      break;
    case NavigationPreset::maya:
      if (middle && alt) return Drag::pan;
      break;
  }
  if (alt && button == Qt::LeftButton) return Drag::orbit;
  if (alt && button == Qt::RightButton && preset != NavigationPreset::blender) return Drag::zoom;
  return std::nullopt;
}

}  // namespace brume
