// The line integral of a Gaussian.

// A Gaussian of center b relative to a line through the origin.
FORMULA_STRUCT LineProfile {
  Real t0;  // where the line is nearest to the center [u]
  Real e;   // a^2 h^2, h the distance there
  Real a;   // 1 / radius [1/u]
};

FORMULA OF(LineProfile) line_profile(Vec3 b, Vec3 w, Real a) {
  OF(LineProfile) line;
  line.t0 = dot(b, w);
  const Vec3 q = a * neg_mul_add(line.t0, w, b);
  line.e = dot(q, q);
  line.a = a;
  return line;
}

// An ellipsoid has b and w warped, and the a of its greatest radius.
FORMULA OF(LineProfile) warped_line_profile(Vec3 b, Vec3 w, Real a) {
  const Real speed2 = dot(w, w);
  OF(LineProfile) line;
  line.t0 = dot(b, w) * (1.0 / speed2);
  const Vec3 p = neg_mul_add(line.t0, w, b);
  line.e = a * a * dot(p, p);
  line.a = a * sqrt(speed2);
  return line;
}

// Optical depth over [0, length] in units of c sqrt(pi) / (2 a).
FORMULA Real unit_depth(OF(LineProfile) line, Real length_) {
  const Real u0 = bounded(-(line.a * line.t0));
  const Real u1 = bounded(line.a * (length_ - line.t0));
  return segment_integral(line.e, u0, u1, line.a * length_);
}

// The same up to the projection of the center on the line, clamped to [0, length]: zero if the
// center lies before it, all of `whole` if beyond, else half a line minus the part before.
FORMULA Real depth_to_projection(OF(LineProfile) line, Real length_, Real whole) {
  const Real u = bounded(line.a * line.t0);
  const Real half_line = exp(-line.e);
  const Real inside =
      select(u < 1.0, half_line * erf_small(min(u, 1.0)), half_line - scaled_erfc(line.e, u));
  return where(line.t0 > 0.0, select(line.t0 >= length_, whole, max(inside, 0.0)));
}

// The mean parameter of the Gaussian on [0, length], in that interval; `depth` is unit_depth()'s.
// Absolute error 1e-5 / a, or 1e-3 of a short segment.
FORMULA Real mean_parameter(OF(LineProfile) line, Real length_, Real depth) {
  const Real u0 = bounded(-(line.a * line.t0));
  const Real u1 = bounded(line.a * (length_ - line.t0));
  const Real k = line.a * length_;
  const Real first = exp(-mul_add(u0, u0, line.e));
  const Real second = exp(-mul_add(u1, u1, line.e));
  const Real mean = line.t0 + (first - second) / max(sqrt_pi * depth, tiny_square) / line.a;
  // That cancels on a short segment: from its middle, by the density's slope there, in terms of
  // order k and k^3.
  const Bool is_short = k * (1.0 + (abs(u0) + abs(u1))) < 1.0;
  const Real m = 0.5 * (u0 + u1);
  const Real second_order = mul_add(m * m, k * k, k * k);
  const Real shift = m * (k * length_) * neg_mul_add(second_order, 1.0 / 90.0, 1.0 / 6.0);
  // Where everything underflows the quotient is meaningless; the mean of half a Gaussian is within
  // 1 / a.
  const Real max_t = max(line.t0, 0.0) + 1.0 / line.a;
  const Real t = select(is_short, 0.5 * length_ - shift, mean);
  return max(min(t, min(max_t, length_)), 0.0);
}
