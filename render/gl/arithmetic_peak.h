#pragma once

#include "render/gl/context.h"

namespace brume::gl {

// Slices per Gaussian x ray pair of the measurement.
constexpr int peak_slices = 4;

// Arithmetic throughput of a device [per second].
struct ArithmeticPeak {
  double multiply_adds = 0.0;
  double exponentials = 0.0;
  double pairs = 0.0;  // Gaussian x ray pairs, over peak_slices slices
};

// Each loop runs until it takes `milliseconds`; best of five. Makes the context current and
// releases it. Throws Error.
ArithmeticPeak measure_peak(Context& context, double milliseconds);

}  // namespace brume::gl
