#pragma once

#include "core/scene/scene.h"

namespace brume {

// A small scene drawn from all that a scene file may hold, extremes and degenerate cases often
// among them: tiny, huge, empty, opaque and coincident Gaussians, lights on the eye, in Gaussians
// and on surfaces, triangles of no area, everything far from the origin. The same for the same
// seed everywhere.
Scene random_scene(unsigned seed);

}  // namespace brume
