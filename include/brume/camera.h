#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brume/export.h"
#include "brume/keys.h"

namespace brume {

// Nothing before this plane is seen. A normal of no length: there is none.
struct ClipPlane {
  glm::dvec3 point{0.0};
  glm::dvec3 normal{0.0};  // to what is seen

  bool operator==(const ClipPlane&) const = default;
};

// A camera with a thin lens, or a pinhole, as views and single samples have it; or an orthographic
// one. vertical_fov is the full vertical angle of view in degrees, in (0, 180).
struct Camera {
  glm::dvec3 eye{0.0, 0.0, 5.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double vertical_fov = 45.0;
  // In place of vertical_fov: an orthographic camera, this high from edge to edge, that sees from
  // the plane of the eye on, > 0 [u].
  std::optional<double> height{};
  double aperture = 0.0;  // radius of the lens, >= 0 [u]; 0: a pinhole, or orthographic
  // The distance of the plane in focus along the axis, > 0 [u]; absent: through the target.
  std::optional<double> focus_distance{};
  // About the way it looks, after `up` [degrees]: positive leans its top to its own right.
  double roll = 0.0;
  // Surfaces before these are not seen, as walls before a room in an editor's view; they shadow as
  // ever. Scene files have none.
  std::array<ClipPlane, 4> clip{};

  bool operator==(const Camera&) const = default;
};

struct CameraKeys {
  Keys<glm::dvec3> eye;
  Keys<glm::dvec3> target;
  Keys<double> vertical_fov;  // of a camera without a height
  Keys<double> height;        // of a camera that has one
  Keys<double> aperture;
  Keys<double> focus_distance;  // of a camera that has one
  Keys<double> roll;

  bool operator==(const CameraKeys&) const = default;
};

// Where a film lies on a larger one, in pixels of both. Rendered, its pixels have the bits that
// they have on the larger one.
struct FilmRegion {
  int x = 0, y = 0;  // of the first pixel
  int full_width = 0, full_height = 0;

  bool operator==(const FilmRegion&) const = default;
};

// The size of a frame in pixels.
struct Film {
  int width = 800;
  int height = 600;
  std::optional<FilmRegion> region{};  // the part of a picture that this is; absent: all of it
  glm::dvec2 shift{0.0};               // of where pixels are sampled from their centers [pixels]

  bool operator==(const Film&) const = default;
};

// The part of a whole film between two corners, fractions of its sides from the upper left
// corner; at least a pixel.
BRUME_EXPORT Film film_region(const Film& film, const glm::dvec2& corner, const glm::dvec2& other);

}  // namespace brume
