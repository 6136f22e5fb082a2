#pragma once

#include <cmath>
#include <glm/vec2.hpp>

namespace brume {

// Point k of a set that covers [0, 1)^2 evenly; of one its corner, which is straight ahead in the
// lobes that are sampled with it.
inline glm::dvec2 even_point(int k, int count) {
  if (count == 1) return {0.0, 0.0};
  constexpr double inverse_golden_ratio = 0.61803398874989484820;
  const double turns = inverse_golden_ratio * k;
  return {(k + 0.5) / count, turns - std::floor(turns)};
}

}  // namespace brume
