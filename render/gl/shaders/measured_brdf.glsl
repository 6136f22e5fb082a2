// MeasuredBrdf of core/scene: the table begins among the values of shade_surfaces.glsl's Arriving.

// Light and eye around the half vector, in [0, pi/2], [0, pi/2] and [0, pi).
vec3 half_angles(vec3 wi, vec3 wo, vec3 n) {
  const vec3 sum = wi + wo;
  const float length_ = length(sum);
  if (!(length_ > 0.0)) return vec3(0.0);
  const vec3 h = sum / length_;
  // Angles from sine and cosine: acos loses half its digits where highlights are.
  const float theta_h = clamp(atan(length(cross(n, h)), dot(n, h)), 0.0, 0.5 * pi);
  const float theta_d = min(atan(0.5 * length(wi - wo), 0.5 * length_), 0.5 * pi);
  // Azimuth around h, from the side that leans away from the normal.
  const vec3 x = dot(n, h) * h - n;
  const vec2 side = vec2(dot(wi, x), dot(wi, cross(h, x)));
  float phi_d = side == vec2(0.0) ? 0.0 : atan(side.y, side.x);
  if (phi_d < 0.0) phi_d += pi;
  return vec3(theta_h, theta_d, phi_d);
}

// Cell i of those whose middles lie around a position.
int cell_near(float position, int i, int cells, bool closes_around) {
  const int cell = int(floor(position - 0.5)) + i;
  return closes_around ? (cell + cells) % cells : clamp(cell, 0, cells - 1);
}

vec3 measured_brdf(int table, vec3 wi, vec3 wo, vec3 n) {
  const vec3 angles = half_angles(wi, wo, n);
  const vec3 coordinate = vec3(sqrt(angles.x / (0.5 * pi)), angles.y / (0.5 * pi), angles.z / pi) *
                          vec3(theta_h_cells, theta_d_cells, phi_d_cells);
  const vec3 f = coordinate - 0.5 - floor(coordinate - 0.5);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const int h = cell_near(coordinate.x, corner_.x, theta_h_cells, false);
    const int d = cell_near(coordinate.y, corner_.y, theta_d_cells, false);
    const int p = cell_near(coordinate.z, corner_.z, phi_d_cells, true);
    const vec3 value = incident_values[table + (h * theta_d_cells + d) * phi_d_cells + p].rgb;
    if (any(lessThan(value, vec3(0.0)))) continue;  // not measured
    const vec3 corner_weights = mix(1.0 - f, f, vec3(corner_));
    sum += corner_weights.x * corner_weights.y * corner_weights.z * value;
    weights += corner_weights.x * corner_weights.y * corner_weights.z;
  }
  return weights > 0.0 ? sum / weights : vec3(0.0);
}
