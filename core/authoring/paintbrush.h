#pragma once

#include <optional>
#include <vector>

#include "core/math/random_source.h"
#include "core/medium/gaussian.h"

namespace brume {

// The paintbrush of section 6 of the paper: Gaussians along a stroke.
struct Paintbrush {
  double radius = 0.3;   // of each Gaussian [u], > 0
  double density = 1.0;  // its peak [1/u], >= 0
  double spacing = 1.0;  // along the stroke, relative to the radius
  double scatter = 0.5;  // maximum offset from the stroke, relative to the radius

  bool operator==(const Paintbrush&) const = default;
};

// The state of one stroke. Gaussians are placed at equal arc lengths, with random offsets shorter
// than scatter * radius perpendicular to the stroke (none for the first). The result depends on the
// path, not on how many points sample it.
class PaintStroke {
 public:
  PaintStroke(const Paintbrush& brush, std::uint64_t seed) : brush_(brush), random_(seed) {}

  // Extends the stroke by a segment to `point`; returns the new Gaussians. A jump that needs more
  // than `longest` of them restarts the stroke.
  std::vector<Gaussian> extend(const glm::dvec3& point);
  static constexpr int max_steps = 4096;

 private:
  Paintbrush brush_;
  RandomSource random_;
  std::optional<glm::dvec3> last_;  // last point of the path
  double distance_to_next_ = 0.0;   // arc length from there to the next Gaussian
};

}  // namespace brume
