#pragma once

#include <glm/vec3.hpp>

#include "core/math/infinity.h"
#include "render/geometry/box.h"

namespace brume {

// Where there is light, as far as that decides where a SourceGrid has nodes.
struct LitSpace {
  Box fog;  // where homogeneous fog needs the finest nodes; without volume: nowhere
  // The part that surfaces do not hide from the lights: levels end there until they hold all
  // surfaces.
  Box open{glm::dvec3(-infinity), glm::dvec3(infinity)};
  bool is_closed = false;  // Nothing beyond is lit or scatters: all levels end there.

  bool operator==(const LitSpace&) const = default;
};

}  // namespace brume
