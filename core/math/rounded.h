#pragma once

namespace brume {

// The number of `digits` significant decimal digits (1 to 17) nearest to a finite value: what a
// program chooses for a user to read should be short.
double rounded(double value, int digits);

}  // namespace brume
