#pragma once

#include <span>
#include <vector>

#include "brume/scene.h"
#include "render/settings.h"
#include "tools/bench/errors/unbiased_error.h"

namespace brume {

// Error of environment light incident at surfaces through the medium against Monte Carlo: with the
// grid of `sliced`, and with the average optical depth (eq. 27).

// A white surface, which casts no shadow.
struct Receiver {
  glm::dvec3 position, normal;
};

// Points of a ball, seen from outside, small enough to be one point of the medium.
std::vector<Receiver> receivers_around(const glm::dvec3& center);

// The error of what they reflect, relative rms over receivers and channels; `other` is that of the
// average optical depth. `samples`: of each run at each receiver.
ComparedError incident_light_error(const std::string& label, const Scene& scene,
                                   const std::vector<Receiver>& receivers, std::size_t samples,
                                   const SourceGridSize& size = {});
// The same on several grids: Monte Carlo takes longest, and is the same for all.
std::vector<ComparedError> arriving_light_errors(const std::string& label, const Scene& scene,
                                                 const std::vector<Receiver>& receivers,
                                                 std::size_t samples,
                                                 std::span<const SourceGridSize> sizes);

// Inside, at the edge of and below clouds, and before and behind a dense one.
std::vector<ComparedError> measure_incident_light(std::size_t samples);

}  // namespace brume
