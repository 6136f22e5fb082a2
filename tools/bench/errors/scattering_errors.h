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

// One light of each kind in place of a point light: in a cloud of depth 3.
struct LightKindRow {
  std::string kind;
  double error = 0.0;   // of the airlight, relative RMSE against the reference
  Spread camera_ratio;  // frame times of a moved camera over a point light's
  Spread edit_ratio;    // the same of frames before each of which the light was moved
};
std::vector<LightKindRow> measure_light_kinds(bool quick);

// Filtered pixels of a sample scene: pictures against 64 whole frames of shifted films.
struct SampleRow {
  std::string scene;
  double one = 0.0;      // relative RMSE of the picture, of one sample a pixel
  double chosen = 0.0;   // of `edge_samples` of pixels that need them
  double sampled = 0.0;  // share of pixels that do
  double pairs = 0.0;    // Gaussian x view ray pairs, over those of one sample
  double time = 0.0;     // of a frame with a moved camera, over one sample
};
std::vector<SampleRow> measure_samples(bool quick);

}  // namespace brume
