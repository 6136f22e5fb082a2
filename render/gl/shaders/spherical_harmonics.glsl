// Real spherical harmonics at a unit direction: sh_basis() of core/math/spherical_harmonics.h.
#include "formulas.glsl"

// q_lm from the two before it: ShRecurrence.
float sh_next(int l, int m, float z, float q, float below) {
  return sh_up[l * sh_bands + m] * (z * q - sh_down[l * sh_bands + m] * below);
}

void sh_basis(vec3 d, out float y[sh_count]) {
  float c = 1.0;  // sin^m(theta) cos(m phi) and sin^m(theta) sin(m phi)
  float s = 0.0;
  float first = 0.5 * inv_sqrt_pi;
  for (int m = 0; m < sh_bands; ++m) {
    if (m > 0) {
      first *= sh_start[m];
      const float turned = c * d.x - s * d.y;
      s = s * d.x + c * d.y;
      c = turned;
    }
    float q = first;
    float below = 0.0;
    for (int l = m; l < sh_bands; ++l) {
      if (l > m) {
        const float next = sh_next(l, m, d.z, q, below);
        below = q;
        q = next;
      }
      y[l * (l + 1) + m] = q * c;
      if (m > 0) y[l * (l + 1) - m] = q * s;
    }
  }
}
