// The error function and its differences, which are optical depths of Gaussians in units of their
// line integral.

// erfcx(x) = exp(x^2) erfc(x) for x >= 0 by a polynomial in t = 1 / (1 + x / 2): relative error
// 3e-7 up to 20, 4e-6 beyond, where every use multiplies it by exp(-400) or less.
FORMULA Real erfcx(Real x) {
  const Real t = 1.0 / mul_add(0.5, x, 1.0);
  Real p = mul_add(-0.0569184758, t, 0.2754870355);
  p = mul_add(p, t, -0.4712418020);
  p = mul_add(p, t, 0.2629913824);
  p = mul_add(p, t, -0.0183402074);
  p = mul_add(p, t, 0.2000166923);
  p = mul_add(p, t, 0.2435849011);
  p = mul_add(p, t, 0.2823328376);
  return t * mul_add(p, t, 0.2820876837);
}

// erf(x) for |x| <= 1: relative error 2e-7.
FORMULA Real erf_small(Real x) {
  const Real y = x * x;
  Real p = mul_add(-0.00056314253, y, 0.0049175541);
  p = mul_add(p, y, -0.0267113168);
  p = mul_add(p, y, 0.1128018051);
  p = mul_add(p, y, -0.3761232495);
  return x * mul_add(p, y, 1.1283791065);
}

// erf(x) to 3e-5, and exactly 1 (to rounding) beyond erf_fast_end, so whole lines are exact: a
// minimax fit without exponential or division, whose error is far below that of slicing.
CONSTANT erf_fast_end = 3.0;
FORMULA Real erf_fast(Real x) {
  const Real z = clamp(x, -erf_fast_end, erf_fast_end);
  const Real y = z * z;
  Real p = mul_add(4.48287326e-08, y, -2.10701818e-06);
  p = mul_add(p, y, 4.373204e-05);
  p = mul_add(p, y, -5.34635078e-04);
  p = mul_add(p, y, 4.35594895e-03);
  p = mul_add(p, y, -2.54599806e-02);
  p = mul_add(p, y, 1.11661121e-01);
  p = mul_add(p, y, -3.75768876e-01);
  return z * mul_add(p, y, 1.12838748);
}

// exp(-x^2) from erf(x), to 5e-3: where a Gaussian's part lies, to 1% of its radius. For small
// Gaussians: where slices are short its slope would show.
FORMULA Real exp_of_erf(Real erf) {
  const Real y = erf * erf;
  Real p = mul_add(0.781783, y, -0.432919);
  p = mul_add(p, y, 0.307849);
  return (1.0 - y) * mul_add(p, y, 1.0);
}

// exp(-e) erfc(|u|), in one exponent.
FORMULA Real scaled_erfc(Real e, Real u) {
  return exp(-mul_add(u, u, e)) * erfcx(abs(u));
}

// Gauss-Legendre points at node * k / 2 on both sides of m, of exp(-(u^2 + e)), times their weight.
FORMULA Real gauss_pair(Real e, Real m, Real k, Uniform node, Uniform weight) {
  const Real s = 0.5 * node * k;
  const Real low = m - s;
  const Real high = m + s;
  return weight * (exp(-mul_add(low, low, e)) + exp(-mul_add(high, high, e)));
}

// The mean of exp(-(u^2 + e)) over a length k around m, with k (1 + 2 |m|) < 1.
FORMULA Real short_mean(Real e, Real m, Real k) {
  return gauss_pair(e, m, k, 0.3399810435848563, 0.6521451548625461) +
         gauss_pair(e, m, k, 0.8611363115940526, 0.3478548451374538);
}

// exp(-e) (erf(u1) - erf(u0)) for u0 <= u1 with relative accuracy also in the tails and for short
// segments; k = u1 - u0, computed without cancellation by the caller.
FORMULA Real segment_integral(Real e, Real u0, Real u1, Real k) {
  const Real full_line_half = exp(-e);
  const Bool straddles = both(u0 <= 0.0, u1 >= 0.0);
  // Both ends far from the center, the common case: the integral of the full line.
  if (ALL(both(straddles, min(abs(u0), abs(u1)) > BY_PRECISION(4.0, 6.0)))) {
    return full_line_half + full_line_half;
  }
  const Bool is_short = k * (1.0 + (abs(u0) + abs(u1))) < 1.0;
  Real sum = full_line_half;
  if (!ALL(is_short)) {
    const Real first = scaled_erfc(e, u0);
    const Real second = scaled_erfc(e, u1);
    const Real across = full_line_half + full_line_half - first - second;
    sum = select(straddles, across, abs(first - second));
  }
  if (ANY(is_short)) {
    const Real m = 0.5 * (u0 + u1);
    sum = select(is_short, inv_sqrt_pi * (k * short_mean(e, m, k)), sum);
  }
  return sum;
}
