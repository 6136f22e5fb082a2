#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace brume {

// A camera with a thin lens, or a pinhole, as views and single samples have it. vertical_fov is the
// full vertical angle of view in degrees, in (0, 180).
struct Camera {
  glm::dvec3 eye{0.0, 0.0, 5.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double vertical_fov = 45.0;
  double aperture = 0.0;  // radius of the lens, >= 0 [u]; 0: a pinhole
  // Of the plane in focus, along the axis, > 0 [u]; absent: through the target.
  std::optional<double> focus_distance{};

  bool operator==(const Camera&) const = default;
};

// Where a film lies on a larger one, in pixels of both.
struct FilmRegion {
  int x = 0, y = 0;  // of the first pixel
  int full_width = 0, full_height = 0;

  bool operator==(const FilmRegion&) const = default;
};

// The size of a frame in pixels.
struct Film {
  int width = 800;
  int height = 600;
  std::optional<FilmRegion> region{};  // a part of the picture; absent: all of it
  glm::dvec2 shift{0.0};               // of where pixels are sampled from their centers [pixels]

  bool operator==(const Film&) const = default;
};

// The part of a whole film between two corners, fractions of its sides from the upper left
// corner; at least a pixel.
Film film_region(const Film& film, const glm::dvec2& corner, const glm::dvec2& other);

// Maps between pixels of a film and rays of a camera, seen as a pinhole. Pixel (x, y) is sampled at
// (x + 0.5, y + 0.5), its center unless the film is shifted; y points down.
class CameraRays {
 public:
  CameraRays(const Camera& camera, const Film& film);

  // Pixels this close to the border of what bounds() finds belong to it.
  static constexpr double pixel_rounding = 1e-6;

  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] const glm::dvec3& forward() const { return forward_; }

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

  // The pixels [x0, x1) x [y0, y1) whose rays may pass within `radius` of a point; may be empty.
  struct PixelRectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
  };
  [[nodiscard]] PixelRectangle bounds(const glm::dvec3& point, double radius) const;

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
