// The environment inscattering of the paper: EnvironmentLight::environment_inscattering().
#include "spherical_harmonics.glsl"

// The environment's coefficients R G B 0; then the polynomials of ScatterTable, one after another.
layout(std430, binding = 7) restrict readonly buffer Inscattering { float inscattering_values[]; };

uniform int has_inscattering;

vec3 environment_inscattering(vec3 w, float T) {
  if (has_inscattering == 0 || !(T > 0.0 && T < scatter_opaque)) return vec3(0.0);
  const float x = scatter_position(T);
  float y[sh_count];
  sh_basis(w, y);
  vec3 sum = vec3(0.0);
  for (int l = 0; l < sh_bands; ++l) {
    vec3 band = vec3(0.0);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      band += y[i] * vec3(inscattering_values[4 * i], inscattering_values[4 * i + 1], inscattering_values[4 * i + 2]);
    }
    const int first = 4 * sh_count + l * scatter_terms;
    float p = inscattering_values[first];
    for (int i = 1; i < scatter_terms; ++i) p = p * x + inscattering_values[first + i];
    sum += p * band;
  }
  return max(T * exp(-T) * sum, vec3(0.0));
}
