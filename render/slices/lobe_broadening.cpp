#include "render/slices/lobe_broadening.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "render/grid/ordinates.h"

namespace brume {
namespace {

// f (exp(s b) - 1) / (exp(s f) - 1), b <= f, without overflow.
double widened(double band, double lobe, double depth) {
  if (depth * lobe < 1e-6) return band;
  return lobe * std::exp(depth * (band - lobe)) * -std::expm1(-depth * band) /
         -std::expm1(-depth * lobe);
}

}  // namespace

LobeBroadening::LobeBroadening(double anisotropy, int first_band) {
  constexpr double negligible = 1e-8;
  const double lobe = forward_lobe(anisotropy, first_band);
  if (lobe < min_lobe) return;
  std::vector<std::array<double, depths>> bands;  // of the table, from first_band on
  for (double band = std::pow(anisotropy, first_band); band > negligible; band *= anisotropy) {
    auto& row = bands.emplace_back();
    for (int k = 0; k < depths; ++k) {
      const double share = static_cast<double>(k) / depths;
      const double depth = static_cast<double>(depth_scale) * share / (1.0 - share);
      row[static_cast<std::size_t>(k)] = band - widened(band, lobe, depth);
    }
  }
  values_.reserve(std::size_t{angles} * depths);
  for (int i = 0; i < angles; ++i) {
    const double half_sine = static_cast<double>(i) / (angles - 1);
    const double cosine = 1.0 - 2.0 * half_sine * half_sine;
    std::array<double, depths> sums{};
    double last = 0.0;
    double legendre = 1.0;  // P_l
    for (int l = 0; l < first_band + static_cast<int>(bands.size()); ++l) {
      if (l >= first_band) {
        const auto& row = bands[static_cast<std::size_t>(l - first_band)];
        for (std::size_t k = 0; k < depths; ++k) sums[k] += (2 * l + 1) * legendre * row[k];
      }
      const double next = ((2 * l + 1) * cosine * legendre - l * last) / (l + 1);
      last = legendre;
      legendre = next;
    }
    for (const double sum : sums) values_.push_back(static_cast<float>(sum));
  }
}

}  // namespace brume
