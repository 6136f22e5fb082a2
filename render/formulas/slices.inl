// The part of a ray's slice that scatters, and where it is.

// exp(-T) (1 - exp(-dT)), without cancellation for small dT.
FORMULA Real scattered_fraction(Real depth, Real increment) {
  return exp(-depth) * select(increment < small_increment,
                              neg_mul_add(0.5 * increment, increment, increment),
                              1.0 - exp(-increment));
}

// The mean of what passes over a length on which the exponent grows evenly, from what passes at its
// begin and end.
FORMULA Real mean_transmittance(Real exponent, Real at_begin, Real at_end) {
  return select(exponent < small_exponent, neg_mul_add(0.5 * exponent, at_begin, at_begin),
                (at_begin - at_end) / max(exponent, tiny));
}

// Where a slice is lit: its optical depth is `increment`, `moment` that times the mean distance at
// which it lies. Over the part around it that lies within the slice, up to the variance of a linear
// density of this mean, or of one that falls to zero; over a thousandth of it at least.
FORMULA_STRUCT LitPart {
  Real center;
  Real half_length;
};

FORMULA OF(LitPart) lit_part(Real begin, Real end, Real increment, Real moment) {
  const Real held = clamp(moment / max(increment, tiny), begin, end);
  const Real width = end - begin;
  const Real half_width = 0.5 * width;
  const Real off = abs(held - 0.5 * (begin + end));
  const Real square = neg_mul_add(3.0 * off, off, half_width * half_width);
  // Half of the length that has the variance of a density that falls linearly to zero, per third of
  // the length over which it falls: sqrt(3 / 2).
  const Real reach =
      select(3.0 * off < half_width, sqrt(max(square, 0.0)), 1.22474487 * (half_width - off));
  // The front counts for more: exp(-T) moves the mean over a length with an optical depth of
  // T by T / (T + 6) of half of it to the front, for small T; what is deeper mostly grows steeply
  // towards its far end.
  const Real front = min(increment, 1.0);
  OF(LitPart) part;
  part.center = max(held - reach * front / (front + 6.0), begin);
  part.half_length = max(min(reach, min(part.center - begin, end - part.center)), 1e-3 * width);
  return part;
}

// How far the light of a light, `distance_` away, has gone through a ball of homogeneous fog,
// FogBall::length(), to p, relative to its center; `along`: the component of -p from there.
FORMULA Real fog_length(Vec3 p, Real along, Real distance_, Uniform radius) {
  const Real square = mul_sub(along, along, dot(p, p)) + radius * radius;
  const Real half_chord = sqrt(max(square, 0.0));
  const Real up_to_end = min(max(half_chord - along, 0.0), half_chord + half_chord);
  return min(up_to_end, min(distance_, max(distance_ + along + half_chord, 0.0)));
}

// Where a ray from p, relative to the center, in the unit direction w is in such a ball:
// FogBall::interval(). Everywhere for the radius 0.
FORMULA_STRUCT FogInterval {
  Real begin;
  Real end;
};

FORMULA OF(FogInterval) fog_interval(Vec3 p, Vec3 w, Uniform radius) {
  OF(FogInterval) fog;
  fog.begin = REAL(0.0);
  fog.end = REAL(endless);
  if (radius == 0.0) return fog;
  const Real along = dot(p, w);
  const Vec3 offset = neg_mul_add(along, w, p);
  const Real half_chord = sqrt(max(radius * radius - dot(offset, offset), 0.0));
  fog.begin = max(-half_chord - along, 0.0);
  fog.end = max(half_chord - along, 0.0);
  return fog;
}

// The length in fog between two places of a ray.
FORMULA Real fog_overlap(OF(FogInterval) fog, Real begin, Real end) {
  return max(min(end, fog.end) - max(begin, fog.begin), 0.0);
}
