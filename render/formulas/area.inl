// Irradiance that area lights send to surfaces, per radiance: area_irradiance() of core/scene.

// The angle of this sine, >= 0, and cosine, of any common factor.
FORMULA Real polar_angle(Real sine, Real cosine) {
  const Real acute = atan(sine / max(abs(cosine), tiny));
  return select(cosine >= 0.0, acute, pi - acute);
}

// What an edge of a polygon from a to b, relative to a surface of normal n, adds to Lambert's sum.
FORMULA Real edge_irradiance(Vec3 a, Vec3 b, Vec3 n) {
  const Vec3 from = unit_or_none(a);
  const Vec3 to = unit_or_none(b);
  const Vec3 turn = cross(from, to);
  const Real sine = sqrt(dot(turn, turn));
  return where(sine > tiny, 0.5 * polar_angle(sine, dot(from, to)) * dot(turn, n) / max(sine, tiny));
}

// A polygon's sum up to one of its corners, and where its outline crosses the horizon.
FORMULA_STRUCT PolygonLight {
  Real irradiance;
  Vec3 leaves;
  Vec3 enters;
};

FORMULA OF(PolygonLight) no_polygon_light(Real zero) {
  OF(PolygonLight) light;
  light.irradiance = zero;
  light.leaves = Vec3(zero, zero, zero);
  light.enters = light.leaves;
  return light;
}

// The sum with the edge from a to b.
FORMULA OF(PolygonLight) with_edge(OF(PolygonLight) light, Vec3 a, Vec3 b, Vec3 n) {
  const Real height_a = dot(a, n);
  const Real height_b = dot(b, n);
  const Bool rises = both(height_a <= 0.0, height_b > 0.0);
  const Bool falls = both(height_a > 0.0, height_b <= 0.0);
  const Real fall = height_a - height_b;
  const Vec3 crossing = mul_add(height_a / copy_sign(max(abs(fall), tiny), fall), b - a, a);
  const Real added = edge_irradiance(select(rises, crossing, a), select(falls, crossing, b), n);
  light.irradiance = light.irradiance + where(max(height_a, height_b) > 0.0, added);
  light.enters = select(rises, crossing, light.enters);
  light.leaves = select(falls, crossing, light.leaves);
  return light;
}

// The whole sum: below 0 where the polygon's back is seen.
FORMULA Real polygon_irradiance(OF(PolygonLight) light, Vec3 n) {
  return light.irradiance + edge_irradiance(light.leaves, light.enters, n);
}

// That of a sphere of this radius, at `to_center` from a surface outside it.
FORMULA Real sphere_irradiance(Vec3 to_center, Vec3 n, Uniform radius) {
  const Real distance2 = max(dot(to_center, to_center), tiny);
  const Real cosine = clamp(dot(to_center, n) / sqrt(distance2), -1.0, 1.0);
  const Real share = min(radius * radius / distance2, 1.0);  // sin^2 of the angle that it fills
  const Real beyond = sqrt(1.0 - share);
  const Real whole = max(cosine, 0.0) * (pi * share);
  // Squared, how far the horizon cuts into it.
  const Real cut = neg_mul_add(cosine, cosine, share);
  const Real root = sqrt(max(cut, 0.0));
  const Real above = share * cosine * polar_angle(root, -(cosine * beyond));
  const Real beside = neg_mul_add(root, beyond, polar_angle(root, beyond));
  return select(cut > 0.0, above + beside, whole);
}
