#include "render/slices/lobe_broadening.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/grid/ordinates.h"

namespace brume {
namespace {

constexpr int first_band = 4;

// Henyey-Greenstein's phase function times 4 pi, in the bands from first_band on.
double without_first_bands(double g, double cosine) {
  double sum = (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
  for (unsigned l = 0; l < first_band; ++l) {
    sum -= (2.0 * l + 1.0) * std::pow(g, l) * std::legendre(l, cosine);
  }
  return sum;
}

// The same light order by order: n times scattered by g is once by g^n.
double loss(double g, double cosine, double depth) {
  const double lobe = forward_lobe(g, first_band);
  double widened = 0.0;
  double weight = lobe / std::expm1(depth * lobe);
  for (int n = 1; n < 200; ++n) {
    weight *= depth / n;
    widened += weight * without_first_bands(std::pow(g, n), cosine);
  }
  return without_first_bands(g, cosine) - widened;
}

TEST(LobeBroadening, IsTheSumOverOrders) {
  for (const double g : {0.7, 0.85, 0.95}) {
    const LobeBroadening table(g, first_band);
    ASSERT_EQ(table.values().size(), std::size_t{LobeBroadening::angles} * LobeBroadening::depths);
    for (const int i : {0, 3, 20, 64, 127}) {
      const double half_sine = i / (LobeBroadening::angles - 1.0);
      for (const int k : {1, 8, 20}) {
        const double share = static_cast<double>(k) / LobeBroadening::depths;
        const double depth = LobeBroadening::depth_scale * share / (1.0 - share);
        const double expected = loss(g, 1.0 - 2.0 * half_sine * half_sine, depth);
        const auto at = static_cast<std::size_t>(i * LobeBroadening::depths + k);
        EXPECT_NEAR(table.values()[at], expected, 1e-5 * std::abs(expected) + 1e-4)
            << "g = " << g << ", " << i << ", " << k;
      }
    }
  }
}

TEST(LobeBroadening, TakesNothingWhereLightIsScatteredOnce) {
  const LobeBroadening table(0.85, first_band);
  for (std::size_t i = 0; i < LobeBroadening::angles; ++i) {
    EXPECT_EQ(table.values()[i * LobeBroadening::depths], 0.0f);
  }
}

TEST(LobeBroadening, IsEmptyForWideLobes) {
  for (const double g : {-0.9, 0.0, 0.6}) EXPECT_TRUE(LobeBroadening(g, first_band).empty()) << g;
}

}  // namespace
}  // namespace brume
