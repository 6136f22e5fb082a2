#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace brume {

// The reconstruction filter of pixels: a Blackman-Harris window, separable, as wide as Cycles has
// it. Pixels are sampled in proportion to it (Ernst, Stamminger and Greiner, "Filter importance
// sampling", 2006), so all samples of a pixel weigh the same, and none belongs to two pixels.
namespace pixel_filter {

inline constexpr double width = 1.5;  // from end to end [pixels]

// Its density at a distance from the pixel's center [1/pixel]; 0 beyond width / 2. Integrates to 1.
double density(double distance);

// Its inverse cumulative distribution: u in [0, 1] to a distance from the center [pixels].
double sample(double u);

}  // namespace pixel_filter

// Where a pixel is sampled, as offsets from its center [pixels], by a Hammersley set warped by the
// filter. The mean of what they see is the filtered pixel. The same for every pixel, so sample k of
// all of them is a picture whose film is shifted. One sample is the center. count >= 1.
std::vector<glm::dvec2> pixel_samples(int count);

}  // namespace brume
