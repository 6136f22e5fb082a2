#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "render/visibility/ray_caster.h"

namespace brume {

// The planes of axis-parallel surfaces: floors, walls, tables. A layer of nodes in one of them sees
// through it, since its links begin and end within the ray caster's margins; one that is halfway
// between two layers blocks their links where it should.
class AxisPlanes {
 public:
  AxisPlanes() = default;  // none
  explicit AxisPlanes(const RayCaster& ray_caster);

  // How far to move nodes at first + i spacing along an axis so that they stay off the planes from
  // `low` to `high`, the large ones before the small: in [-0.5, 0.5) spacing, 0 if they are off
  // them.
  [[nodiscard]] double shift(int axis, double low, double high, double first, double spacing) const;

 private:
  struct Plane {
    double coordinate = 0.0;
    double area = 0.0;  // [u^2]
  };
  std::array<std::vector<Plane>, 3> planes_;  // ascending
};

}  // namespace brume
