#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/paths/majorant_grid.h"
#include "render/paths/path_kernels.h"
#include "render/paths/path_random.h"

namespace brume {

// The Gaussians of a medium, without homogeneous density and noise, for random walks: densities,
// optical depths in closed form, and collisions by delta tracking under local majorants. Densities
// are extinction. Thread-safe.
class PathMedium {
 public:
  // Keeps a reference to `medium`, whose tolerance is the error of all depths.
  explicit PathMedium(const MediumIndex& medium);

  [[nodiscard]] const MediumIndex& index() const { return medium_; }
  [[nodiscard]] const MajorantGrid& grid() const { return grid_; }

  // Sum of the Gaussians' densities at x [1/u].
  [[nodiscard]] double density(const glm::dvec3& x) const;

  // Optical depth of a segment; w unit, length may be +inf.
  [[nodiscard]] double depth(const glm::dvec3& origin, const glm::dvec3& w, double length) const;

  // Distance to the next collision, drawn from density(t) exp(-depth(t)); +inf if the walk reaches
  // `length` (may be +inf) without one.
  [[nodiscard]] double collision(const glm::dvec3& origin, const glm::dvec3& w, double length,
                                 PathRandom& random) const;

  // After so many tentative collisions of one segment the rest is found from its closed form:
  // opaque Gaussians much smaller than a cell would take millions.
  static constexpr int max_tentative = 64;

 private:
  [[nodiscard]] double collision_by_depth(const glm::dvec3& origin, const glm::dvec3& w,
                                          double length, PathRandom& random) const;

  // The indices of the Gaussians in an order in which neighbours in space are near each other.
  static std::vector<std::uint32_t> spatial_order(const MediumIndex& medium);

  const MediumIndex& medium_;
  GaussianArrays arrays_;
  MajorantGrid grid_;
};

}  // namespace brume
