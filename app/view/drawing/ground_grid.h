#pragma once

#include <optional>

#include "app/view/drawing/overlay.h"
#include "brume/frame.h"

namespace brume {

// The surfaces before the grid, as far as known: a frame's depth, and the camera it was rendered
// with.
struct GridDepth {
  const Frame& frame;
  const Camera& camera;
};

// The distance between lines of the ground grid, of 1, 2 or 5 times a power of ten [u]: about a
// tenth of the view's distance.
double ground_grid_step(double distance);

// Draws a grid on the ground, y = 0, around the point below the target, with the axes x and z in
// their colours. It fades with distance and where it is seen edge-on, and is faint behind surfaces,
// where their depth is known. `distance`: from the eye to what is looked at [u].
void add_ground_grid(Overlay& overlay, const Camera& camera, const Film& film, double distance,
                     const std::optional<GridDepth>& depth);

}  // namespace brume
