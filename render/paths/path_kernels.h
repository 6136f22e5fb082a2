#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"

namespace brume {

// Gaussians as arrays for vector kernels in double, padded with some of no density.
class GaussianArrays {
 public:
  void clear();
  // Segments farther than `cutoff_radius` from the center ignore it.
  void add(const GaussianTerm<double>& g, double cutoff_radius);
  void add(const GaussianArrays& from, std::size_t i);
  // Call after the last add().
  void pad();

  [[nodiscard]] std::size_t size() const { return size_; }

  // Optical depth of a segment; w unit, length finite. Relative error 1e-14 per Gaussian.
  [[nodiscard]] double depth(const glm::dvec3& origin, const glm::dvec3& w, double length) const;

  // Sum of the densities of some Gaussians at x [1/u]. `indices` may be read up to max_lanes past
  // its end, where any valid index must stand.
  [[nodiscard]] double density(std::span<const std::uint32_t> indices, const glm::dvec3& x) const;

  static constexpr std::size_t max_lanes = 8;

 private:
  std::vector<double> x_, y_, z_, a_, peak_, scale_, cutoff2_;
  std::size_t size_ = 0;
};

}  // namespace brume
