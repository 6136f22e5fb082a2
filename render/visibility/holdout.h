#pragma once

#include <algorithm>
#include <span>

#include "brume/surface.h"
#include "render/visibility/surface_hit.h"

namespace brume {

// The eye sees none of surfaces that are held out, but what is in front of them; alpha is as if
// they were open.

inline bool has_holdouts(std::span<const Surface> surfaces) {
  return std::ranges::any_of(surfaces, &Surface::holdout);
}

inline bool is_held_out(std::span<const Surface> surfaces, const SurfaceHit& hit) {
  return hit && !hit.is_light() && surfaces[static_cast<std::size_t>(hit.surface)].holdout;
}

}  // namespace brume
