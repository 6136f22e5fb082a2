#include "core/medium/written_radii.h"

#include "core/math/rounded.h"

namespace brume {

glm::dvec3 written_radii(const Gaussian& gaussian) {
  glm::dvec3 radii = gaussian.radii();
  for (int k = 0; k < 3; ++k) {
    // They are products: what was read as 0.3 is written as that.
    const double shorter = rounded(radii[k], 15);
    if (shorter / gaussian.radius == gaussian.shape.stretch[k]) radii[k] = shorter;
  }
  return radii;
}

}  // namespace brume
