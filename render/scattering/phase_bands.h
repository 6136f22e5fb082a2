#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "core/math/spherical_harmonics.h"
#include "render/grid/ordinates.h"

namespace brume {

// Delta-M truncation of the Henyey-Greenstein phase function (Wiscombe 1977): the bands that a
// SourceGrid stores, and the forward lobe of the rest. Band l of the light around a point times g^l
// - p_l is that band of the scattered light without the lobe, whose bands p_l for l < 4 are
// forward_lobe(), or g^4 (-1)^l for a backward one, and g^l beyond.
class PhaseBands {
 public:
  static constexpr int max_bands = grid_bands;

  // One band if isotropic, else four.
  explicit PhaseBands(double anisotropy);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] std::span<const double> factors() const {
    return std::span(factors_).first(static_cast<std::size_t>(count_));
  }
  // All basis functions at a unit direction, times their band's factor.
  [[nodiscard]] std::array<float, sh_size(max_bands)> at(const glm::dvec3& w) const;
  // The truncated phase function at the cosine of the scattering angle [1/sr].
  [[nodiscard]] double phase(double cosine) const;
  // The same times 4 pi: coefficients of powers of the cosine.
  [[nodiscard]] std::array<double, max_bands> phase_powers() const;

 private:
  int count_;
  std::array<double, max_bands> factors_;
};

}  // namespace brume
