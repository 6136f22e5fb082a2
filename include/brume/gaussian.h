#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brume/export.h"

namespace brume {

// How the matter of a Gaussian scatters and shines. By default as the medium, and not at all.
struct GaussianOptics {
  // Single-scattering albedo, RGB in (0, 1]: extinction is density / albedo. Absent: the medium's.
  std::optional<glm::dvec3> albedo{};
  // Radiance of an opaque body of it that lets nothing through and scatters nothing: RGB >= 0
  // [W/(sr u^2)], per unit of extinction optical depth.
  glm::dvec3 emission{0.0};

  bool operator==(const GaussianOptics&) const = default;
};

// The ellipsoid that a Gaussian is; by default a ball.
struct GaussianShape {
  // Radii along its own axes over the greatest of them: in [limits::min_stretch, 1], one is 1.
  glm::dvec3 stretch{1.0};
  // Turns its own axes into those of the scene; a unit quaternion, to 1e-9.
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};

  bool operator==(const GaussianShape&) const = default;
};

// Identifies a group of Gaussians in its scene (brume/group.h); 0: none.
using GroupId = std::uint32_t;

// One Gaussian of a medium: b_i(x) = density * exp(-|x - center|^2 / radius^2)  [1/u]. The paper's
// a_i is 1 / radius, its c_i is density. Domain: radius > 0, density >= 0, all finite.
//
// An ellipsoid has its greatest radius there, so that the ball of that radius encloses it, and
// |warp(shape) (x - center)| in place of |x - center|.
struct BRUME_EXPORT Gaussian {
  glm::dvec3 center{0.0};
  double radius = 1.0;
  double density = 0.0;
  GaussianOptics optics{};
  GroupId group = 0;
  GaussianShape shape{};

  [[nodiscard]] bool is_ball() const { return shape == GaussianShape(); }
  // Along its own axes [u].
  [[nodiscard]] glm::dvec3 radii() const { return radius * shape.stretch; }
  // The radius of the ball of its volume, and so of its mass [u].
  [[nodiscard]] double mean_radius() const;
  // Makes it an ellipsoid, or of equal radii a ball. Those below limits::min_stretch of the
  // greatest become as much; the rotation, of any length > 0, a unit quaternion.
  void set_radii(const glm::dvec3& radii, const glm::dquat& rotation);

  bool operator==(const Gaussian&) const = default;
};

// R diag(1 / stretch) R^T for the rotation R: turns the ellipsoid into the ball of its greatest
// radius. Symmetric; eigenvalues in [1, 1 / limits::min_stretch].
BRUME_EXPORT glm::dmat3 warp(const GaussianShape& shape);

// The Gaussian under a linear map of the space around its center: the ellipsoid that its points
// become, its own axes in the order that they had. `map` must be invertible; elongations beyond the
// limit are cut off.
BRUME_EXPORT void transform(Gaussian& gaussian, const glm::dmat3& map);

// Identifies a Gaussian in its medium; ids are never reused.
using GaussianId = std::uint64_t;

// Persistent id of a Gaussian across the frames of a sequence.
using GaussianNumber = std::uint32_t;

}  // namespace brume
