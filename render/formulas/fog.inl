// Homogeneous fog lit by a point light, along a ray: the paper's eqs. 17 to 19, over the angle at
// the light.

FORMULA_STRUCT FogRay {
  Real ts;        // where the ray is nearest to the light
  Real offset2;   // the square of the distance there,
  Real h;         // and the distance, such that 1 / r^2 is finite
  Real start2;    // h^2 + ts^2
  Real span;      // the angle at the light between the ray's start and its end
  Real at_start;  // the angle there between light and view
  // In a ball of fog its radius, else 0; then where the ray starts, from the ball's center, its
  // direction, and the light from where it starts.
  Uniform radius;
  Vec3 from_center;
  Vec3 w;
  Vec3 light;
};

// A ray within a ball of fog (its radius 0: fog is everywhere) that starts at `from_center`, in the
// unit direction w; the light is at `light` from there.
FORMULA OF(FogRay) fog_ray(Vec3 light, Vec3 w, Real length_, Uniform h_min, Uniform b0,
                           Vec3 from_center, Uniform radius) {
  const Real ts = dot(light, w);
  const Vec3 offset = neg_mul_add(ts, w, light);
  const Real offset2 = dot(offset, offset);
  OF(FogRay) ray;
  ray.radius = radius;
  ray.from_center = from_center;
  ray.w = w;
  ray.light = light;
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
  // In a ball the way from the light may pass little fog.
  const Real end = min(length_, radius == 0.0 ? t_max : REAL(max_extra_path));
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
  Real from_light = distance_;
  if (ray.radius != 0.0) {
    const Vec3 p = mul_add(t, ray.w, ray.from_center);
    const Vec3 to_light = neg_mul_add(t, ray.w, ray.light);
    from_light = fog_length(p, dot(p, to_light) / max(distance_, tiny), distance_, ray.radius);
  }
  const Real transmitted = exp(-b0 * (t + from_light));
  if (g == 0.0) return transmitted;
  return transmitted * henyey_greenstein(cos_theta(along, distance_), g);
}
