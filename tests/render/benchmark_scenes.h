#pragma once

#include "core/scene/scene.h"

namespace brume {

// What the speed claims are measured on.

// A sample scene of resources/scenes, without its surfaces: the airlight alone.
Scene sample_airlight(const char* name);

// Two thick overlapping Gaussians, one light.
Scene two_gaussians();

// n Gaussians in a unit box with the same optical depth through it for every n: radii shrink so
// that a ray always meets about the same number of them.
Medium box_of(int count);

// That box before a camera, with so many lights around it.
Scene box_scene(int count, int lights);

// CPU seconds that this process has used so far, all threads together.
double cpu_seconds();

}  // namespace brume
