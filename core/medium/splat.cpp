#include "core/medium/splat.h"

#include <cmath>
#include <numbers>

namespace brume {

Gaussian gaussian_of(const Splat& splat) {
  const glm::dvec3& s = splat.deviations;
  const double mean =
      std::numbers::sqrt2 * std::exp((std::log(s.x) + std::log(s.y) + std::log(s.z)) / 3.0);
  Gaussian g{splat.center, mean, splat.depth * std::numbers::inv_sqrtpi / mean};
  g.set_radii(std::numbers::sqrt2 * s, splat.rotation);
  return g;
}

}  // namespace brume
