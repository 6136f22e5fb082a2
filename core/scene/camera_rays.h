#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "brume/camera.h"
#include "core/medium/gaussian_term.h"

namespace brume {

// Maps between pixels of a film and rays of a camera, seen as a pinhole. Pixel (x, y) is sampled at
// (x + 0.5, y + 0.5), its center unless the film is shifted; y points down.
class CameraRays {
 public:
  CameraRays(const Camera& camera, const Film& film);

  // Pixels this close to the border of what bounds() finds belong to it.
  static constexpr double pixel_rounding = 1e-6;

  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }
  [[nodiscard]] const glm::dvec3& up() const { return up_; }  // of the picture

  // The unit direction from the eye through a film position (pixels).
  [[nodiscard]] glm::dvec3 direction(double x, double y) const {
    return glm::normalize(corner_ + x * per_x_ + y * per_y_);
  }

  // The parametrisation of direction(), for kernels: the direction through (x, y) is that of corner
  // + x per_x + y per_y, at distance 1 along forward().
  struct FilmPlane {
    glm::dvec3 corner, per_x, per_y;
  };
  [[nodiscard]] FilmPlane plane() const { return {corner_, per_x_, per_y_}; }

  // The film position that forward() goes through: the center of the whole film, unless shifted.
  [[nodiscard]] glm::dvec2 axis() const {
    return 0.5 * glm::dvec2(region_.full_width, region_.full_height) -
           glm::dvec2(region_.x, region_.y) - shift_;
  }

  // A film around the axis that contains this one, shifted or not: its size, and where this one
  // begins on it [pixels].
  struct Surround {
    glm::ivec2 size;
    glm::dvec2 start;
  };
  [[nodiscard]] Surround surround() const;

  // Film position of a point, and its depth along forward() in z [u]; for z <= 0 it is behind the
  // eye and x and y are 0.
  [[nodiscard]] glm::dvec3 project(const glm::dvec3& point) const;

  // The pixels [x0, x1) x [y0, y1) whose rays may pass within `radius` of a Gaussian's center, of
  // an ellipsoid in the space in which it is a ball; may be empty.
  struct PixelRectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
  };
  [[nodiscard]] PixelRectangle bounds(const GaussianTerm<double>& gaussian, double radius) const;

  // Half the angle subtended by the central pixel [radians].
  [[nodiscard]] double pixel_half_angle() const;

 private:
  glm::dvec3 eye_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  glm::dvec2 half_size_;  // of the whole film at distance 1
  FilmRegion region_;
  glm::dvec2 shift_;
  glm::ivec2 pixels_;  // of the film
  // A film position from the eye, at distance 1 along forward_: corner_ + x per_x_ + y per_y_.
  glm::dvec3 corner_;
  glm::dvec3 per_x_;
  glm::dvec3 per_y_;
};

}  // namespace brume
