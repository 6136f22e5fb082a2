#pragma once

#include <string>
#include <vector>

#include "tools/bench/measure/measurement.h"

namespace brume {

// Errors and costs of all orders of scattering, against paths: clouds of 300 Gaussians
// over depth, albedo and anisotropy, of more Gaussians that are smaller, and sample scenes with
// what their surfaces do.
struct AllOrdersRow {
  std::string scene;
  // Relative RMSE of the airlight against paths, their noise taken out: of light scattered once,
  // and of all; 0 where that is less than the noise.
  double single = 0.0, multiple = 0.0;
  double noise = 0.0;  // of the paths
  int sweeps = 0;
  double solve_milliseconds = 0.0;  // from scratch
  double edit_milliseconds = 0.0;   // once a Gaussian was moved, from the solution before
  Spread camera_ratio;              // frame times of a moved camera, all orders over one
  double megabytes = 0.0;           // of the light on the grid
};
std::vector<AllOrdersRow> measure_all_orders(bool quick);

}  // namespace brume
