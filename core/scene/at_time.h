#pragma once

#include "core/scene/scene.h"

namespace brume {

// Whether a scene is another one at another time, its noise aside.
bool is_animated(const Scene& scene);

// The time of the last key or the last frame of a sequence, 0 if none is later [s].
double last_moment(const Scene& scene);

// The Gaussians of a scene with those of its sequences and all particles that its emitters may have
// at a time: what limits::gaussians bounds. No moment has more.
std::size_t gaussian_count(const Scene& scene);

// The scene as it is at a time [s]: values that have keys are those of that time, its medium has
// the particles of all emitters and the Gaussians of all sequences, and there are neither keys nor
// emitters nor sequences.
Scene at_time(const Scene& scene, double time);

}  // namespace brume
