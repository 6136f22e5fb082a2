// Homogeneous fog lit by a point light, along a ray: the paper's eqs. 17 to 19, over the angle at
// the light.

FORMULA_STRUCT FogRay {
  Real ts;        // where the ray is nearest to the light
  Real offset2;   // the square of the distance there,
  Real h;         // and the distance, such that 1 / r^2 is finite
  Real start2;    // h^2 + ts^2
  Real span;      // the angle at the light between the ray's start and its end
  Real at_start;  // the angle there between light and view
};

FORMULA OF(FogRay) fog_ray(Real ts, Real offset2, Real length_, Uniform h_min, Uniform b0) {
  OF(FogRay) ray;
  ray.ts = ts;
  ray.offset2 = offset2;
  // A light on the ray needs some distance from it; see PointLightRay.
  ray.h = max(max(sqrt(offset2), h_min), max(abs(ts) * light_rounding, min_light_gap));
  ray.start2 = mul_add(ts, ts, ray.h * ray.h);
  // Attenuation uses the true length; only 1/r^2 is clamped.
  const Real start = sqrt(mul_add(ts, ts, offset2));
  // Beyond t_max the path exceeds the shortest one by an opaque depth.
  const Uniform max_extra_path = fog_detour_depth / b0;
  // start - ts, which cancels for a light straight ahead.
  const Real min_extra_path = select(ts > 0.0, offset2 / max(start + ts, tiny), start - ts);
  const Real t_max =
      max_extra_path * (start + max_extra_path + start) / (2.0 * (max_extra_path + min_extra_path));
  const Real end = min(length_, t_max);
  const Real adjacent = neg_mul_add(ts, end, ray.start2);
  const Real acute = atan(ray.h * end / max(abs(adjacent), tiny));
  ray.span = select(adjacent >= 0.0, acute, pi - acute);
  ray.at_start = 0.5 * pi - atan(ts / ray.h);
  return ray;
}

// Light that the fog sends to the eye at the angle phi at the light, from that of the start, per
// angle, times h / b0.
FORMULA Real fog_light(OF(FogRay) ray, Real phi, Uniform b0, Uniform g) {
  const Real sine = sin(phi);
  const Real t = ray.start2 * sine / max(mul_add(ray.h, cos(phi), ray.ts * sine), tiny);
  const Real along = t - ray.ts;
  const Real distance_ = sqrt(mul_add(along, along, ray.offset2));
  const Real transmitted = exp(-b0 * (t + distance_));
  if (g == 0.0) return transmitted;
  return transmitted * henyey_greenstein(cos_theta(along, distance_), g);
}
