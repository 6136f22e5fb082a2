#include "core/math/random_source.h"

namespace brume {

glm::dvec2 RandomSource::in_disc() {
  while (true) {
    const double x = 2.0 * uniform() - 1.0;
    const double y = 2.0 * uniform() - 1.0;
    if (x * x + y * y < 1.0) return {x, y};
  }
}

glm::dvec3 RandomSource::in_ball() {
  while (true) {
    const double x = 2.0 * uniform() - 1.0;
    const double y = 2.0 * uniform() - 1.0;
    const double z = 2.0 * uniform() - 1.0;
    if (x * x + y * y + z * z < 1.0) return {x, y, z};
  }
}

}  // namespace brume
