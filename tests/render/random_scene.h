#pragma once

#include "brume/scene.h"

namespace brume {

// A small scene drawn from all that a scene file may hold, extremes and degenerate cases often
// among them: tiny, huge, empty, opaque and coincident Gaussians, lights on the eye, in Gaussians
// and on surfaces, triangles of no area, everything far from the origin. The same for the same
// seed everywhere.
Scene random_scene(unsigned seed);

// Fog as somebody might make it, with what is hard to measure: lights in view, Gaussians smaller
// than a pixel, opaque ones, edges and shadows of surfaces. 32 x 24 pixels. The same for the same
// seed everywhere.
Scene random_fog_scene(unsigned seed);

}  // namespace brume
