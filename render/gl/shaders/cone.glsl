// The cone around the rays of a work group of 64 that start at one point, and what touches it.
shared vec4 axis;            // of the cone, and the cosine of its half angle
shared vec3 directions[64];  // of the rays, unit; 0: there is none

// Called by one invocation when all directions are set.
void find_cone() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 64; ++i) sum += directions[i];
  // Rays all around have no middle; then everything touches them.
  const float length_ = length(sum);
  float cosine = -1.0;
  if (length_ > 1e-3) {
    sum /= length_;
    cosine = 1.0;
    for (int i = 0; i < 64; ++i) {
      if (directions[i] != vec3(0.0)) cosine = min(cosine, dot(sum, directions[i]));
    }
  }
  axis = vec4(sum, cosine - 1e-6);
}

// A ball around b, seen from where the rays start.
bool touches_cone(vec3 b, float cutoff_radius) {
  if (axis.w <= 0.0) return true;
  const float along = dot(b, axis.xyz);
  const float across = length(b - along * axis.xyz);
  return across * axis.w - along * sqrt(max(1.0 - axis.w * axis.w, 0.0)) <= 1.0001 * cutoff_radius;
}
