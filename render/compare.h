#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/io/image_file.h"

namespace brume {

// How image A differs from image B, the reference, over all values of the channels compared.
// Two infinite values of the same sign count as equal and enter nothing else.
struct Comparison {
  double rel_rmse = 0.0;         // rms(A - B) / rms(B); +inf if only B is zero
  double max_error = 0.0;        // max |A - B|
  double bias = 0.0;             // mean(A - B) / mean(B); +-inf if only the mean of B is zero
  std::size_t incomparable = 0;  // values NaN in either, or infinite in one only; left out above
};

struct ChannelPair {
  std::span<const float> a;
  std::span<const float> b;
};

// Both spans of each pair have the same length (assert).
Comparison compare(std::span<const ChannelPair> channels);

// The names of the channels that make up a layer of an image: "" is the beauty's R G B, "Z" the
// channel Z, "airlight" the channels airlight.R airlight.G airlight.B; empty if it has no such.
std::vector<std::string> layer_channels(const ImageLayers& image, const std::string& layer);

}  // namespace brume
