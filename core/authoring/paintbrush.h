#pragma once

#include <optional>
#include <vector>

#include "brume/brush.h"
#include "brume/gaussian.h"
#include "core/math/random_source.h"

namespace brume {

// A random factor of a brush's jitter: 2^jitter to 2^-jitter; 1 without, which draws no number.
double jitter_factor(double jitter, RandomSource& random);

// The ball drawn out `stretch` >= 1 times along a unit direction.
Gaussian stretched(const Gaussian& ball, const glm::dvec3& direction, double stretch);

// The state of one stroke. Gaussians are placed at equal arc lengths, with random offsets shorter
// than scatter * radius perpendicular to the stroke (none for the first, which has no direction and
// is a ball). The result depends on the path, not on how many points sample it.
class PaintStroke {
 public:
  PaintStroke(const Paintbrush& brush, std::uint64_t seed) : brush_(brush), random_(seed) {}

  // Extends the stroke by a segment to `point`; returns the new Gaussians. A jump that needs more
  // than `longest` of them restarts the stroke.
  // `size` and `strength` > 0 multiply radius and density, as the pressure of a pen does.
  std::vector<Gaussian> extend(const glm::dvec3& point, double size = 1.0, double strength = 1.0);
  static constexpr int max_steps = 4096;
  // The next point begins anew, with nothing between.
  void lift() { last_.reset(); }

 private:
  // At an offset from the stroke, relative to the maximum.
  Gaussian dab(const glm::dvec3& center, double offset, double size, double strength);

  Paintbrush brush_;
  RandomSource random_;
  std::optional<glm::dvec3> last_;  // last point of the path
  double distance_to_next_ = 0.0;   // arc length from there to the next Gaussian
};

}  // namespace brume
