#pragma once

#include <cstddef>
#include <cstdint>

#include "brume/frame.h"
#include "render/settings.h"

namespace brume {

// What pictures and measurements of their errors cost. It is counted, not timed, so that what is
// measured for so much is the same on every machine and under any load. The unit is about a
// nanosecond of one core of 2023; costs of sample scenes are within a factor of two of it.

// Of a frame that was rendered with the settings, without what a renderer may have kept from
// others. The surfaces' share of a grid and all lights but one are left out: it is rather too
// small.
double picture_work(const Frame& frame, const Settings& settings);

// Of a path that drew so many random numbers. With the first come depths of Gaussians towards
// lights; most of many are of collisions in opaque fog, which only ask for densities.
double path_work(std::size_t gaussians, std::uint64_t draws);

// Of the integral along a view ray, with so many point lights.
double integral_work(std::size_t gaussians, std::size_t lights, bool has_environment);

}  // namespace brume
