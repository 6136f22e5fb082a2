#include "render/scattering/phase_bands.h"

#include <cmath>
#include <numbers>
#include <ranges>

namespace brume {

PhaseBands::PhaseBands(double anisotropy) : count_(anisotropy == 0.0 ? 1 : max_bands) {
  double factor = 1.0;
  double lobe_scattering =
      anisotropy > 0.0 ? forward_lobe(anisotropy, max_bands) : std::pow(anisotropy, max_bands);
  for (double& f : factors_) {
    f = factor - lobe_scattering;
    factor *= anisotropy;
    lobe_scattering = std::copysign(lobe_scattering, factor);
  }
}

std::array<float, sh_size(PhaseBands::max_bands)> PhaseBands::at(const glm::dvec3& w) const {
  const ShVector<double> basis = sh_basis(count_, w);
  std::array<float, sh_size(max_bands)> result{};
  for (int l = 0; l < count_; ++l) {
    for (int m = -l; m <= l; ++m) {
      const std::size_t i = sh_index(l, m);
      result[i] = static_cast<float>(factors_[static_cast<std::size_t>(l)] * basis[i]);
    }
  }
  return result;
}

double PhaseBands::phase(double cosine) const {
  double sum = 0.0;
  for (const double power : phase_powers() | std::views::reverse) sum = sum * cosine + power;
  return sum / (4.0 * std::numbers::pi);
}

std::array<double, PhaseBands::max_bands> PhaseBands::phase_powers() const {
  // Legendre's polynomials, up to the third.
  static_assert(max_bands == 4);
  const double p1 = 3.0 * factors_[1];
  const double p2 = 5.0 * factors_[2];
  const double p3 = 7.0 * factors_[3];
  return {factors_[0] - 0.5 * p2, p1 - 1.5 * p3, 1.5 * p2, 2.5 * p3};
}

}  // namespace brume
