// What a medium scatters of an environment as the paper has it: EnvironmentLight::glow().
#include "spherical_harmonics.glsl"

// The environment's coefficients R G B 0; then the polynomials of ScatterTable, one after another.
layout(std430, binding = 7) readonly buffer Glow { float glow_values[]; };

uniform int has_glow;

vec3 glow(vec3 w, float T) {
  if (has_glow == 0 || !(T > 0.0 && T < scatter_opaque)) return vec3(0.0);
  const float root = sqrt(T);
  const float x = scatter_scale * root / (root + 1.0) - 1.0;
  float y[sh_count];
  sh_basis(w, y);
  vec3 sum = vec3(0.0);
  for (int l = 0; l < sh_bands; ++l) {
    vec3 band = vec3(0.0);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      band += y[i] * vec3(glow_values[4 * i], glow_values[4 * i + 1], glow_values[4 * i + 2]);
    }
    const int first = 4 * sh_count + l * scatter_terms;
    float p = glow_values[first];
    for (int i = 1; i < scatter_terms; ++i) p = p * x + glow_values[first + i];
    sum += p * band;
  }
  return max(T * exp(-T) * sum, vec3(0.0));
}
