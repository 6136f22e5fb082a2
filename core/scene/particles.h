#pragma once

#include <vector>

#include "core/medium/gaussian.h"
#include "core/scene/emitter.h"

namespace brume {

// Limit of an emitter's live particles; the oldest are dropped first.
inline constexpr int particle_limit = 100'000;

// Maximum number of live particles of an emitter.
std::size_t max_particles(const Emitter& emitter);

// The particles of an emitter at a time [s]. Particle k is born at k / rate and lives for the
// lifetime; its state depends only on its seed and age, so any time can be evaluated. Radius and
// density are interpolated linearly from birth to death. Values stay within the limits of scene
// files.
std::vector<Gaussian> particles_at(const Emitter& emitter, double time);

}  // namespace brume
