#pragma once

namespace brume::coefficient {

#define CONSTANT inline constexpr double
#include "render/formulas/constants.inl"
#undef CONSTANT

// Gauss-Legendre with eight points on [0, 1], clustered at the far end by x -> 1 - (1 - x)^2.
struct FogRule {
  float nodes[8] = {};
  float weights[8] = {};

  constexpr FogRule() {
    constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                0.9602898564975363};
    constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                  0.1012285362903763};
    for (int i = 0; i < 8; ++i) {
      const double y = 0.5 * (1.0 + (i < 4 ? -node[3 - i] : node[i - 4]));
      const double wy = 0.5 * (i < 4 ? weight[3 - i] : weight[i - 4]);
      nodes[i] = static_cast<float>(1.0 - (1.0 - y) * (1.0 - y));
      weights[i] = static_cast<float>(2.0 * (1.0 - y) * wy);
    }
  }
};
inline constexpr FogRule fog_rule;

}  // namespace brume::coefficient
