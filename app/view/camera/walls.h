#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "brume/camera.h"

namespace brume {

class SurfacePicker;

// The planes of walls that are between where a camera stands now and the room that it looked at
// from `inside`: with them it sees into the room. Without a wall on the way from there, or if it
// has turned away from the room, there are none.
std::array<ClipPlane, 4> walls_before(SurfacePicker& surfaces, const Camera& inside,
                                      const Camera& now, const Film& film);

}  // namespace brume
