#pragma once

#include <vector>

#include "core/medium/gaussian.h"
#include "core/scene/emitter.h"

namespace brume {

// At most so many of an emitter's particles are there at a time, the youngest.
inline constexpr int most_particles = 100'000;

// How many particles of an emitter are there at any time, at most.
std::size_t max_particles(const Emitter& emitter);

// The particles of an emitter at a time [s]: particle k is born at k / rate, and lives while its
// age is below the lifetime. Each is where its own seed and its age say, so any time can be asked
// for, in any order. Radius and density go evenly from birth to death. Numbers stay within what
// scene files may hold.
std::vector<Gaussian> particles_at(const Emitter& emitter, double time);

}  // namespace brume
