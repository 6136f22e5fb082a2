#pragma once

namespace brume {

// The scaled complementary error function exp(x^2) erfc(x), x >= 0; decreasing from 1, about
// 1 / (x sqrt(pi)) for large x. Relative error at most 1e-14 (double), 3e-6 (float).
template <class Real>
Real erfcx(Real x);

extern template double erfcx(double);
extern template float erfcx(float);

}  // namespace brume
