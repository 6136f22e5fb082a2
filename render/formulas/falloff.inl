// How light falls off along rays, and with its direction.

// The mean of 1 / r^2 over s in [a, b], b > a, s from the point of a ray that is nearest to a
// light, whose distance there is h: the angle that the part spans at the light, divided by h (b -
// a).
FORMULA Real mean_inverse_square(Real a, Real b, Real h2) {
  const Real dots = mul_add(a, b, h2);
  const Real crosses = sqrt(h2) * (b - a);
  const Real ratio = crosses / dots;
  // atan(x) = x P(x^2) to 2e-6 there.
  const Bool is_small = both(dots > 0.0, ratio < 0.4);
  const Real y = ratio * ratio;
  Real p = mul_add(-0.09090909, y, 0.11111111);
  p = mul_add(p, y, -0.14285714);
  p = mul_add(p, y, 0.2);
  p = mul_add(p, y, -0.33333333);
  const Real direct = mul_add(p, y, 1.0) / max(dots, tiny);
  if (ALL(is_small)) return direct;
  const Real acute = atan(crosses / max(abs(dots), tiny));
  const Real angle = select(dots >= 0.0, acute, pi - acute);
  return select(is_small, direct, angle / max(crosses, tiny));
}

// The indefinite integral over s of (s along - across) / r^3, r^2 = s^2 + h2: of the light that
// arrives with a cosine, of whose axis these are components.
FORMULA Real cosine_integral(Real along, Real across, Real h2, Real s) {
  return -mul_add(across / h2, s, along) / sqrt(mul_add(s, s, h2));
}

// LightFalloff::at() of a cone, in the unit direction of these components along its azimuths and
// its axis: 1 - cos t, which is the versine, keeps its digits near the axis.
FORMULA Real cone_falloff(Vec3 w, Uniform dark_versine, Uniform per_versine) {
  const Real sine2 = mul_add(w.x, w.x, w.y * w.y);
  const Real versine = select(w.z > 0.0, sine2 / (1.0 + w.z), 1.0 - w.z);
  const Real share = clamp((dark_versine - versine) * per_versine, 0.0, 1.0);
  return share * share;
}

// The parameters s at which a ray crosses the cone of a versine; `far` where it does not. `along`
// and `across`: the ray's direction, and its offset from the light where s is 0, which is h2 long,
// as cone_falloff() has components; the light lies at s along - across.
FORMULA Vec2 cone_edges(Vec3 along, Vec3 across, Real h2, Uniform versine, Uniform far) {
  // sine^2 (s^2 + h2) = |(s along - across).xy|^2, by sines, which keep their digits where the cone
  // is narrow.
  const Uniform sine2 = versine * (2 - versine);
  const Real along2 = mul_add(along.x, along.x, along.y * along.y);
  const Real across2 = mul_add(across.x, across.x, across.y * across.y);
  const Real b = mul_add(along.x, across.x, along.y * across.y);
  const Real cross_ = mul_sub(along.x, across.y, along.y * across.x);
  const Real a = sine2 - along2;
  const Real c = mul_sub(sine2, h2, across2);
  // b^2 - a c
  const Real square = neg_mul_add(cross_, cross_, sine2 * neg_mul_add(a, h2, across2));
  const Real sum = -(b + copy_sign(sqrt(max(square, 0.0)), b));
  const Bool meets = square >= 0.0;
  return Vec2(select(both(meets, a != 0.0), clamp(sum / a, -far, far), far),
              select(both(meets, sum != 0.0), clamp(c / sum, -far, far), far));
}
