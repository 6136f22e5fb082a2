#pragma once

#include <string>
#include <vector>

namespace brume {

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
