#pragma once

#include "render/gl/context.h"

namespace brume::gl {

// Slices that a pair of the limit touches.
constexpr int peak_slices = 4;

// What a device can do where nothing but its arithmetic counts [per second].
struct ArithmeticPeak {
  double multiply_adds = 0.0;
  double exponentials = 0.0;
  double pairs = 0.0;  // of Gaussian and ray, over peak_slices slices
};

// Measured: each loop runs until it takes `milliseconds`, and its best time of five counts. Makes
// the context current and lets it go again. Throws Error.
ArithmeticPeak measure_peak(Context& context, double milliseconds);

}  // namespace brume::gl
