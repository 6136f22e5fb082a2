#pragma once

#include <vector>

#include "brume/emitter.h"
#include "brume/gaussian.h"

namespace brume {

// Limit of an emitter's live particles; the oldest are dropped first.
inline constexpr int particle_limit = 100'000;

// Maximum number of live particles of an emitter.
std::size_t max_particles(const Emitter& emitter);

// The number of particles emitted until a time >= 0 [s]: the integral of the emitter's rate.
double emitted_until(const Emitter& emitter, double time);

// The particles of an emitter at a time [s]. Particle k is born at k / rate, or where the rate has
// keyframes, when its integral passes k; it has the emitter's values at its birth for life. Its
// state depends only on seed and age, so any time can be evaluated. Radius, density and emission
// are interpolated linearly from birth to death. Values stay within the limits of scene files.
std::vector<Gaussian> particles_at(const Emitter& emitter, double time);

}  // namespace brume
