#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/io/image/image_file.h"

namespace brume {

// Difference of image A from the reference B over all values of the compared channels. Two
// infinities of the same sign count as equal and are otherwise ignored.
struct Comparison {
  double rel_rmse = 0.0;   // rms(A - B) / rms(B); +inf if only B is zero
  double max_error = 0.0;  // max |A - B|
  double bias = 0.0;       // mean(A - B) / mean(B); +-inf if only the mean of B is zero
  std::size_t incomparable =
      0;  // values that are NaN in either image or infinite in one only; excluded above
};

struct ChannelPair {
  std::span<const float> a;
  std::span<const float> b;
};

// Both spans of each pair have the same length (assert).
Comparison compare(std::span<const ChannelPair> channels);

// Channel names of a layer: "" is R G B, "Z" is Z, "airlight" is airlight.R/G/B. Empty if the image
// has no such layer.
std::vector<std::string> layer_channels(const ImageLayers& image, const std::string& layer);

}  // namespace brume
