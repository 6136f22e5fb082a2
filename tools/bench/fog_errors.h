#pragma once

#include <vector>

#include "render/error_estimate.h"

namespace brume {

// How the errors of `paper`, and of `sliced` with 24 slices, go with the thickness of the fog:
// resources/scenes/dense_cloud with all densities times a factor.
struct ThicknessRow {
  double factor = 1.0;
  double greatest_depth = 0.0;
  ErrorEstimate paper, sliced;
};
std::vector<ThicknessRow> measure_thickness(std::size_t pixels);

// Errors of `sliced` with 24 slices in clouds that only an environment lights: an even sky, and one
// with a sun.
struct SkyRow {
  int gaussians = 0;
  double depth = 0.0;
  double anisotropy = 0.0;
  ErrorEstimate even, sunny;
};
std::vector<SkyRow> measure_skies();

}  // namespace brume
