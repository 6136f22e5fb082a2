#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"

namespace brume {

// Pointers to the arrays below.
struct BallColumns {
  const double *x, *y, *z, *radius2;
};
struct GaussianColumns {
  const double *x, *y, *z, *a, *peak, *scale, *cutoff2;
  std::array<const double*, 6> warp;   // of Ellipsoid: xx yy zz yz xz xy; null: all are balls
  const std::uint8_t* has_ellipsoids;  // of each group
  BallColumns groups, clusters;
};

// Gaussians as arrays for vector kernels in double. Segments are tested against balls around
// clusters of eight groups of eight consecutive Gaussians first, then of the groups: neighbours
// should be added one after the other.
class GaussianArrays {
 public:
  // Segments farther than `cutoff_radius` from the center ignore it.
  void add(const GaussianTerm<double>& g, double cutoff_radius);
  // Call once, after the last add().
  void finish();

  // Optical depth of a segment; w unit, length finite. Relative error 1e-14 per Gaussian.
  [[nodiscard]] double depth(const glm::dvec3& origin, const glm::dvec3& w, double length) const;

  // Sum of the densities of some Gaussians at x [1/u]. `indices` may be read up to max_lanes past
  // its end, where any valid index must stand.
  [[nodiscard]] double density(std::span<const std::uint32_t> indices, const glm::dvec3& x) const;

  // The size of a group, and padding.
  static constexpr std::size_t max_lanes = 8;

 private:
  // Balls around eight balls each; radius2 < 0: nothing.
  struct Balls {
    std::vector<double> x, y, z, radius2;

    void enclose(const BallColumns& inner, std::size_t count);
    [[nodiscard]] BallColumns columns() const {
      return {x.data(), y.data(), z.data(), radius2.data()};
    }
  };
  static void pad(std::vector<double>& values, double value);
  [[nodiscard]] GaussianColumns columns() const;

  std::vector<double> x_, y_, z_, a_, peak_, scale_, cutoff2_;
  std::array<std::vector<double>, 6> warp_;  // from the first ellipsoid on
  std::vector<std::uint8_t> has_ellipsoids_;
  Balls groups_, clusters_;
};

}  // namespace brume
