#pragma once

#include "brume/scene.h"

namespace brume {

// Objects that shadow and light themselves, without any light.

// A hollow ball of radius 1, open at the top from the polar angle `to`, seen from above.
Scene bowl_scene(double to, Surface::Transfer transfer);

// A ball over a floor in one mesh; the floor is at z = 0.
Scene ball_over_floor(Surface::Transfer transfer);

}  // namespace brume
