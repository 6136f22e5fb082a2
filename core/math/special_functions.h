#pragma once

namespace brume {

// The scaled complementary error function exp(x^2) erfc(x), x >= 0; decreasing from 1, about
// 1 / (x sqrt(pi)) for large x. Relative error at most 1e-14 (double), 3e-6 (float).
template <class Real>
Real erfcx(Real x);

extern template double erfcx(double);
extern template float erfcx(float);

// The entire exponential integral Ein(x) = integral of (1 - exp(-t)) / t over t in [0, x], x >= 0;
// relative error at most 1e-8. (Abramowitz and Stegun, 5.1.39 and 5.1.40.)
double entire_exponential_integral(double x);

// Dawson's integral exp(-x^2) times the integral of exp(t^2) over [0, x], x >= 0; relative error at
// most 2e-7. (Rybicki's sum of exponentials, Computers in Physics 3, 85, 1989.)
double dawson(double x);

}  // namespace brume
