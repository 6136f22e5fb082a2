#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "core/math/infinity.h"

namespace brume {

Film film_region(const Film& film, const glm::dvec2& corner, const glm::dvec2& other) {
  const glm::dvec2 size(film.width, film.height);
  const glm::ivec2 last = glm::ivec2(size) - 1;
  const glm::ivec2 start = glm::clamp(
      glm::ivec2(glm::floor(glm::min(corner, other) * size + CameraRays::pixel_rounding)),
      glm::ivec2(0), last);
  const glm::ivec2 end =
      glm::clamp(glm::ivec2(glm::ceil(glm::max(corner, other) * size - CameraRays::pixel_rounding)),
                 start + 1, last + 1);
  return {end.x - start.x, end.y - start.y, FilmRegion{start.x, start.y, film.width, film.height}};
}

CameraRays::CameraRays(const Camera& camera, const Film& film)
    : is_parallel_(camera.height.has_value()),
      eye_(camera.eye),
      region_(film.region.value_or(FilmRegion{0, 0, film.width, film.height})),
      shift_(film.shift) {
  for (const ClipPlane& plane : camera.clip) {
    if (plane.normal != glm::dvec3(0.0)) clip_.push_back(plane);
  }
  const glm::dvec2 size(whole_size());
  const glm::dvec3 view = camera.target - camera.eye;
  const double distance = glm::length(view);
  forward_ = distance > 0.0 ? view / distance : glm::dvec3(0.0, 0.0, -1.0);
  glm::dvec3 right = glm::cross(forward_, camera.up);
  if (glm::dot(right, right) <= 1e-24 * glm::dot(camera.up, camera.up)) {
    // `up` parallel to the view is degenerate; any perpendicular axis will do.
    const glm::dvec3 other =
        std::abs(forward_.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    right = glm::cross(forward_, other);
  }
  right = glm::normalize(right);
  const glm::dvec3 up = glm::cross(right, forward_);
  const double roll = glm::radians(camera.roll);
  right_ = std::cos(roll) * right - std::sin(roll) * up;
  up_ = std::cos(roll) * up + std::sin(roll) * right;
  half_size_.y =
      is_parallel_ ? 0.5 * *camera.height : std::tan(0.5 * glm::radians(camera.vertical_fov));
  half_size_.x = half_size_.y * size.x / size.y;
  corner_ = forward_ - half_size_.x * right_ + half_size_.y * up_;
  per_x_ = 2.0 * half_size_.x / size.x * right_;
  per_y_ = -2.0 * half_size_.y / size.y * up_;
  corner_ += shift_.x * per_x_ + shift_.y * per_y_;
  offset_corner_ = (shift_.x - 0.5 * size.x) * per_x_ + (shift_.y - 0.5 * size.y) * per_y_;
}

double CameraRays::max_offset() const {
  const glm::dvec2 size(whole_size());
  double distance = 0.0;
  for (const glm::dvec2 corner : {glm::dvec2(0.0), {size.x, 0.0}, {0.0, size.y}, size}) {
    distance = std::max(distance, glm::length(whole_offset(corner)));
  }
  return distance;
}

glm::dvec3 CameraRays::project(const glm::dvec3& point) const {
  const glm::dvec3 position = project_on_whole(point);
  if (!(position.z > 0.0)) return position;
  return position - glm::dvec3(first_pixel(), 0.0);
}

glm::dvec3 CameraRays::project_on_whole(const glm::dvec3& point) const {
  const glm::dvec3 q = point - eye_;
  const double z = glm::dot(q, forward_);
  if (!(z > 0.0)) return {0.0, 0.0, z};
  const double scale = is_parallel_ ? 1.0 : z;
  const double u = glm::dot(q, right_) / (scale * half_size_.x);
  const double v = glm::dot(q, up_) / (scale * half_size_.y);
  return {0.5 * (u + 1.0) * region_.full_width - shift_.x,
          0.5 * (1.0 - v) * region_.full_height - shift_.y, z};
}

namespace {

// The stretch of one film axis, in half sizes from -1 to 1, that a disc of `radius` around (x, z)
// covers as seen from the origin along z.
glm::dvec2 covered(double x, double z, double radius, double half_size) {
  const double square = x * x + z * z - radius * radius;
  if (square <= 0.0) return {-1.0, 1.0};
  if (z <= -radius) return {1.0, -1.0};  // all of it behind the eye
  // Its tangents through the origin. One that does not go forward bounds nothing in view.
  const double length = std::sqrt(square);
  const glm::dvec2 low(x * length - z * radius, z * length + x * radius);
  const glm::dvec2 high(x * length + z * radius, z * length - x * radius);
  return {low.y > 0.0 ? std::max(-1.0, low.x / (low.y * half_size)) : -1.0,
          high.y > 0.0 ? std::min(1.0, high.x / (high.y * half_size)) : 1.0};
}

// The same of an ellipse; `squares` holds the products of its reaches along x and z.
glm::dvec2 covered(double x, double z, double radius, const glm::dmat2& squares, double half_size) {
  const double front = z * z - squares[1][1];
  const double side = x * x - squares[0][0];
  // In part behind the eye: as the disc around it.
  if (!(z > 0.0) || !(front > 0.0)) return covered(x, z, radius, half_size);
  const double middle = x * z - squares[0][1];
  const double root = std::sqrt(std::max(middle * middle - front * side, 0.0));
  return {std::max(-1.0, (middle - root) / (front * half_size)),
          std::min(1.0, (middle + root) / (front * half_size))};
}

// The same as seen along z from everywhere, of what reaches as far along both axes.
glm::dvec2 covered_in_parallel(double x, double z, const glm::dvec2& reach, double half_size) {
  if (z <= -reach.y) return {1.0, -1.0};  // all of it behind the eye
  return {std::max(-1.0, (x - reach.x) / half_size), std::min(1.0, (x + reach.x) / half_size)};
}

}  // namespace

CameraRays::Surround CameraRays::surround() const {
  const glm::dvec2 margin = glm::ceil(glm::abs(shift_));
  return {whole_size() + 2 * glm::ivec2(margin), margin + shift_};
}

CameraRays::PixelRectangle CameraRays::bounds_on_whole(const GaussianTerm<double>& gaussian,
                                                       double radius) const {
  const glm::dvec3 q = gaussian.b - eye_;
  const double z = glm::dot(q, forward_);
  const Surround film = surround();
  const double half_width = half_size_.x * film.size.x / region_.full_width;
  const double half_height = half_size_.y * film.size.y / region_.full_height;
  const auto along = [&](const glm::dvec3& axis, double half_size) {
    const double x = glm::dot(q, axis);
    if (!gaussian.ellipsoid) {
      return is_parallel_ ? covered_in_parallel(x, z, glm::dvec2(radius), half_size)
                          : covered(x, z, radius, half_size);
    }
    const auto& [warp, axes, stretch] = *gaussian.ellipsoid;
    const glm::dvec3 x_reach = radius * stretch * (axis * axes);
    const glm::dvec3 z_reach = radius * stretch * (forward_ * axes);
    if (is_parallel_) {
      return covered_in_parallel(x, z, {glm::length(x_reach), glm::length(z_reach)}, half_size);
    }
    const double xz = glm::dot(x_reach, z_reach);
    const glm::dmat2 squares(glm::dot(x_reach, x_reach), xz, xz, glm::dot(z_reach, z_reach));
    return covered(x, z, radius, squares, half_size);
  };
  const glm::dvec2 u = along(right_, half_width);
  const glm::dvec2 v = along(-up_, half_height);
  if (!(u[0] < u[1]) || !(v[0] < v[1])) return {};
  // Pixels whose centre lies inside, with a little room for rounding.
  const auto first = [](double s, int size, double start) {
    return static_cast<int>(std::ceil(0.5 * (s + 1.0) * size - 0.5 - pixel_rounding - start));
  };
  const auto last = [](double s, int size, double start) {
    return static_cast<int>(std::floor(0.5 * (s + 1.0) * size - 0.5 + pixel_rounding - start)) + 1;
  };
  return {std::max(first(u[0], film.size.x, film.start.x), 0),
          std::max(first(v[0], film.size.y, film.start.y), 0),
          std::min(last(u[1], film.size.x, film.start.x), region_.full_width),
          std::min(last(v[1], film.size.y, film.start.y), region_.full_height)};
}

double CameraRays::pixel_half_angle() const {
  return is_parallel_ ? 0.0 : std::atan(half_size_.y / region_.full_height);
}

double CameraRays::pixel_width() const {
  return is_parallel_ ? 2.0 * half_size_.y / region_.full_height : 0.0;
}

double CameraRays::clip_end(const glm::dvec3& origin, const glm::dvec3& direction) const {
  double end = 0.0;
  for (const ClipPlane& plane : clip_) {
    const double distance = glm::dot(plane.point - origin, plane.normal);
    const double along = glm::dot(direction, plane.normal);
    if (distance > 0.0) end = std::max(end, along > 0.0 ? distance / along : infinity);
  }
  return end;
}

}  // namespace brume
