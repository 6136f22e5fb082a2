#pragma once

#include <cstdint>
#include <vector>

#include "brume/frame.h"
#include "render/util/job.h"

namespace brume {

// The content of a pixel that varies within it, so that its center alone does not tell its filtered
// value: nothing, something seen through smooth fog, or the fog itself.
enum class PixelDetail : std::uint8_t { none, surfaces, fog };

// Finds them in a frame of one sample a pixel, part of a picture of this mean radiance: where
// distances, what is behind the fog, or the fog itself differ by more than a linear change from
// pixel to pixel, in any of eight directions.
// Gradients do not count: the filter is symmetric. Pixels at the border, some of whose neighbours
// are unknown, are taken to have details.
std::vector<PixelDetail> find_details(const Frame& frame, double mean_radiance, const Job& job);

}  // namespace brume
