// Rays displaced by noise: GLSL counterpart of render/simd/noise-inl.h.
#include "gaussian.glsl"
#include "ellipsoids.glsl"

uniform float noise_amplitude;  // over noise_lattice::rms; 0: none
uniform float noise_frequency;  // [cells/u]
uniform vec3 noise_cell;        // of the eye
uniform uint noise_key;

uint lattice_hash(uint x) {
  x = (x ^ (x >> hash_shifts[0])) * hash_factors[0];
  x = (x ^ (x >> hash_shifts[1])) * hash_factors[1];
  return x ^ (x >> hash_shifts[2]);
}

float signed_by(float value, uint bits, int shift) {
  return uintBitsToFloat(floatBitsToUint(value) ^ ((bits << shift) & 0x80000000u));
}

// The gradient of w . A at the point t w, per cell.
vec3 potential_gradient(vec3 w, float t) {
  const float along = clamp(noise_frequency * t, -max_lattice_distance,
                           max_lattice_distance);
  const vec3 cell = along * w + noise_cell;
  const vec3 low = floor(cell);
  const vec3 f = cell - low;
  const uvec3 node = uvec3(ivec3(low));
  const vec3 fade = f * f * f * ((noise_fade[0] * f + noise_fade[1]) * f + noise_fade[2]);
  const vec3 rise = noise_fade_slope * f * f * (f - 1.0) * (f - 1.0);
  const uint last = uint(noise_period - 1);
  vec3 sum = vec3(0.0);
  for (int corner_ = 0; corner_ < 8; ++corner_) {
    const ivec3 c = ivec3(corner_ & 1, (corner_ >> 1) & 1, corner_ >> 2);
    const uvec3 n = (node + uvec3(c)) & last;
    const uint number = n.x + uint(noise_period) * (n.y + uint(noise_period) * n.z);
    const uint bits = lattice_hash(noise_key ^ number);
    vec3 gradient;
    for (int j = 0; j < 3; ++j) {
      gradient[j] =
          signed_by(w.x, bits, j) + signed_by(w.y, bits, 3 + j) + signed_by(w.z, bits, 6 + j);
    }
    const float height = dot(gradient, f - vec3(c));
    const vec3 weight = mix(1.0 - fade, fade, vec3(c));
    const vec3 slope = mix(-rise, rise, vec3(c));
    sum += weight.x * weight.y * weight.z * gradient +
           height * vec3(slope.x * weight.y * weight.z, weight.x * slope.y * weight.z,
                         weight.x * weight.y * slope.z);
  }
  return sum;
}

// Displaces a ray that passes a Gaussian, as warped, at the vector p from its center. Gaussians
// beyond max_undisplaced_e stay culled.
void displace(inout LineProfile line, vec3 p, vec3 w, float a, float max_undisplaced_e) {
  if (noise_amplitude > 0.0 && line.e <= max_undisplaced_e) {
    const vec3 offset = a * p - noise_amplitude * cross(w, potential_gradient(w, line.t0));
    line.e = dot(offset, offset);
  }
}

// line_profile() for a displaced ray.
LineProfile view_line_profile(vec3 b, vec3 w, float a, float max_undisplaced_e) {
  LineProfile line = line_profile(b, w, a);
  displace(line, b - line.t0 * w, w, a, max_undisplaced_e);
  return line;
}

#ifdef ELLIPSOIDS
// The same of what may be an ellipsoid.
LineProfile view_line_profile(EllipsoidWarp e, vec3 b, vec3 w, float a, float max_undisplaced_e) {
  if (!is_ellipsoid(e)) return view_line_profile(b, w, a, max_undisplaced_e);
  const mat3 warp = warp_of(e);
  const vec3 q = warp * b;
  const vec3 v = warp * w;
  LineProfile line = warped_line_profile(q, v, a);
  displace(line, q - line.t0 * v, w, a, max_undisplaced_e);
  return line;
}
#endif
