// View rays, which noise may displace. With PARALLEL defined it is included after rays.glsl.
#include "formulas.glsl"
#include "ellipsoids.glsl"

uniform float noise_amplitude;  // over noise_lattice::rms; 0: none
uniform float noise_frequency;  // [cells/u]
uniform vec3 noise_cell;        // of the eye
uniform uint noise_key;

// Displaces a ray that passes a Gaussian, as warped, at the vector p from its center. Gaussians
// beyond max_undisplaced_e stay culled.
void displace(inout LineProfile line, vec3 p, vec3 w, float a, float max_undisplaced_e) {
  if (noise_amplitude > 0.0 && line.e <= max_undisplaced_e) {
    const float along = clamp(noise_frequency * line.t0, -max_lattice_distance, max_lattice_distance);
#ifdef PARALLEL
    const vec3 cell = along * w + (noise_frequency * ray_offset + noise_cell);
#else
    const vec3 cell = along * w + noise_cell;
#endif
    const vec3 gradient = potential_gradient(cell, w, noise_key);
    line.e = displaced_e(p, w, gradient, a, noise_amplitude);
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
