// Reflection of metallic-roughness materials: see GgxReflection of core/scene/materials/ggx.h.

FORMULA Real smith_root(Real alpha2, Real cosine) {
  return sqrt(mul_add(1.0 - alpha2, cosine * cosine, alpha2));
}

// D of a surface of normal n for the unit half vector h.
FORMULA Real ggx_distribution(Vec3 n, Vec3 h, Real alpha2) {
  // 1 - (N.H)^2 has no digits where highlights are: the sine of the angle has.
  const Vec3 sine = cross(n, h);
  const Real sine2 = min(dot(sine, sine), 1.0);
  const Real spread = mul_add(alpha2, 1.0 - sine2, sine2);
  return alpha2 / (pi * (spread * spread));
}

// The density of mirrored rays: ggx_pdf().
FORMULA Real ggx_ray_density(Real distribution, Real cos_eye, Real alpha2) {
  return 0.5 * distribution / (cos_eye + smith_root(alpha2, cos_eye));
}

// D V: what microfacets reflect, without Fresnel's term.
FORMULA Real microfacets(Vec3 n, Vec3 h, Real cos_light, Real cos_eye, Real alpha) {
  const Real alpha2 = alpha * alpha;
  const Real distribution = ggx_distribution(n, h, alpha2);
  const Real visibility = 0.5 / mul_add(cos_light, smith_root(alpha2, cos_eye),
                                        cos_eye * smith_root(alpha2, cos_light));
  return distribution * visibility;
}

// Schlick's (1 - V.H)^5; V.H is |L + V| / 2.
FORMULA Real schlick(Real sum_length) {
  const Real x = 1.0 - min(0.5 * sum_length, 1.0);
  return x * x * (x * x) * x;
}
