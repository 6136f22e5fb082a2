// The cosine of the angle by which light turns towards the eye at a point that is `along` past the
// light on the ray and `distance` from it.
FORMULA Real cos_theta(Real along, Real distance_) {
  return -(along / max(distance_, tiny));
}

// The phase function of Henyey and Greenstein (1941) relative to isotropic scattering, 4 pi p; see
// core/transport/phase_function.h.
FORMULA Real henyey_greenstein(Real cosine, Uniform g) {
  const Real s = neg_mul_add(2 * g, cosine, 1 + g * g);
  return (1 - g * g) / (s * sqrt(s));
}
