#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "brume/camera.h"
#include "core/medium/gaussian_term.h"

namespace brume {

// Maps between pixels of a film and rays of a camera, seen as a pinhole or orthographic. Pixel (x,
// y) is sampled at (x + 0.5, y + 0.5), its center unless the film is shifted; y points down. All is
// computed in pixels of the whole film, so that a region's pixels have the same bits.
//
// The rays of a pinhole start at the eye; those of an orthographic camera are parallel and start in
// the plane through the eye across forward().
class CameraRays {
 public:
  CameraRays(const Camera& camera, const Film& film);

  // Pixels this close to the border of what bounds() finds belong to it.
  static constexpr double pixel_rounding = 1e-6;

  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }
  [[nodiscard]] const glm::dvec3& up() const { return up_; }  // of the picture
  [[nodiscard]] bool is_parallel() const { return is_parallel_; }

  // The film's first pixel on the whole one.
  [[nodiscard]] glm::ivec2 first_pixel() const { return {region_.x, region_.y}; }
  [[nodiscard]] glm::ivec2 whole_size() const { return {region_.full_width, region_.full_height}; }

  // The unit direction of the ray through a film position (pixels).
  [[nodiscard]] glm::dvec3 direction(double x, double y) const {
    return whole_direction(glm::dvec2(x, y) + glm::dvec2(first_pixel()));
  }
  // The same through a position on the whole film.
  [[nodiscard]] glm::dvec3 whole_direction(const glm::dvec2& position) const {
    if (is_parallel_) return forward_;
    return glm::normalize(corner_ + position.x * per_x_ + position.y * per_y_);
  }

  // Where the ray through a film position starts, relative to the eye; 0 unless rays are parallel.
  [[nodiscard]] glm::dvec3 offset(double x, double y) const {
    return whole_offset(glm::dvec2(x, y) + glm::dvec2(first_pixel()));
  }
  [[nodiscard]] glm::dvec3 whole_offset(const glm::dvec2& position) const {
    if (!is_parallel_) return glm::dvec3(0.0);
    return offset_corner_ + position.x * per_x_ + position.y * per_y_;
  }
  // The same in the world.
  [[nodiscard]] glm::dvec3 origin(double x, double y) const { return eye_ + offset(x, y); }
  // The greatest distance from the eye to where a ray of the whole film starts.
  [[nodiscard]] double max_offset() const;
  // Distance to a point along the ray through it; signed where rays are parallel.
  [[nodiscard]] double distance_to(const glm::dvec3& point) const {
    const glm::dvec3 q = point - eye_;
    return is_parallel_ ? glm::dot(q, forward_) : glm::length(q);
  }

  // The unit direction of the ray through a point.
  [[nodiscard]] glm::dvec3 towards(const glm::dvec3& point) const {
    return is_parallel_ ? forward_ : glm::normalize(point - eye_);
  }

  // The distance at which a view ray, from the eye or its offset from there, has passed the
  // camera's clipping planes [u]; infinite if it never does.
  [[nodiscard]] double clip_end(const glm::dvec3& origin, const glm::dvec3& direction) const;
  [[nodiscard]] const std::vector<ClipPlane>& clip() const { return clip_; }

  // The parametrisation of rays, for kernels: the ray through (x, y) on the whole film passes
  // corner + x per_x + y per_y from the eye, at distance 1 along forward().
  struct FilmPlane {
    glm::dvec3 corner, per_x, per_y;
  };
  [[nodiscard]] FilmPlane plane() const { return {corner_, per_x_, per_y_}; }

  // The position on the whole film that forward() goes through: its center, unless shifted.
  [[nodiscard]] glm::dvec2 axis() const { return 0.5 * glm::dvec2(whole_size()) - shift_; }

  // A film around the axis that contains the whole one, shifted or not: its size, and where the
  // whole one begins on it [pixels].
  struct Surround {
    glm::ivec2 size;
    glm::dvec2 start;
  };
  [[nodiscard]] Surround surround() const;

  // Film position of a point, and its depth along forward() in z [u]; for z <= 0 it is behind the
  // eye and x and y are 0.
  [[nodiscard]] glm::dvec3 project(const glm::dvec3& point) const;
  // The same on the whole film.
  [[nodiscard]] glm::dvec3 project_on_whole(const glm::dvec3& point) const;

  // The pixels [x0, x1) x [y0, y1) of the whole film whose rays may pass within `radius` of a
  // Gaussian's center, of an ellipsoid in the space in which it is a ball; may be empty.
  struct PixelRectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
    bool operator==(const PixelRectangle&) const = default;
  };
  [[nodiscard]] PixelRectangle bounds_on_whole(const GaussianTerm<double>& gaussian,
                                               double radius) const;

  // A pixel at distance d along forward() is as wide as pixel_width() + 2 d pixel_half_angle(): of
  // a pinhole's, half the angle that the central one subtends [radians], else 0.
  [[nodiscard]] double pixel_half_angle() const;
  // An orthographic camera's height [u], else 0.
  [[nodiscard]] double pixel_width() const;

 private:
  bool is_parallel_;
  std::vector<ClipPlane> clip_;
  glm::dvec3 eye_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  glm::dvec2 half_size_;  // of the whole film, at distance 1 of a pinhole's
  FilmRegion region_;
  glm::dvec2 shift_;
  // A position on the whole film from the eye, at distance 1 along forward_: corner_ + x per_x_ + y
  // per_y_.
  glm::dvec3 corner_;
  glm::dvec3 per_x_;
  glm::dvec3 per_y_;
  glm::dvec3 offset_corner_;  // the same from the plane through the eye
};

}  // namespace brume
