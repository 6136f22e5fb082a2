#pragma once

#include <optional>
#include <vector>

#include "core/authoring/random_source.h"
#include "core/medium/gaussian.h"

namespace brume {

// The paintbrush of section 6 of the paper: Gaussians along a stroke.
struct Paintbrush {
  double radius = 0.3;   // of each Gaussian [u], > 0
  double density = 1.0;  // its peak [1/u], >= 0
  double spacing = 1.0;  // from one to the next along the stroke, over the radius, >= 0.05
  double scatter = 0.5;  // greatest offset from the stroke, over the radius, in [0, 1]

  bool operator==(const Paintbrush&) const = default;
};

// A stroke in the making. Gaussians stand at equal distances along the polyline of its points,
// moved by a random vector in the plane across the stroke that is shorter than scatter * radius.
// The first one, which has no direction yet, stands on the first point. Where they stand depends on
// the path only, not on how many points it is given by.
class PaintStroke {
 public:
  PaintStroke(const Paintbrush& brush, std::uint64_t seed) : brush_(brush), random_(seed) {}

  // The Gaussians that are due when the stroke goes on straight to `point`. A point so far off that
  // there would be more than `longest` of them begins the stroke anew.
  std::vector<Gaussian> to(const glm::dvec3& point);
  static constexpr int longest = 4096;

 private:
  Paintbrush brush_;
  RandomSource random_;
  std::optional<glm::dvec3> last_;  // point of the path
  double left_ = 0.0;               // of the path from there to the next Gaussian [u]
};

}  // namespace brume
