// Arithmetic throughput of the device: the airlight's inner loops on registers only, as an upper
// bound for the passes.
#include "formulas.glsl"

layout(local_size_x = 128) in;

layout(std430, binding = 0) writeonly buffer Results { float results[]; };

uniform int kind;   // 0: multiply and add; 1: exp; 2: pairs of Gaussian and ray, as in `sliced`
uniform int count;  // of rounds; eight operations each, or one pair
uniform float seed;

void main() {
  const uint id = gl_GlobalInvocationID.x;
  const float own = seed * float(id % 64u);
  float sum = 0.0;
  if (kind == 0) {
    vec4 a = vec4(own, own + 0.1, own + 0.2, own + 0.3);
    vec4 b = a + 0.05;
    for (int i = 0; i < count; ++i) {
      a = a * 0.999 + 0.001;
      b = b * 0.998 + 0.002;
    }
    sum = dot(a, vec4(1.0)) + dot(b, vec4(1.0));
  } else if (kind == 1) {
    vec4 a = vec4(own, own + 0.1, own + 0.2, own + 0.3);
    vec4 b = a + 0.05;
    for (int i = 0; i < count; ++i) {
      a = exp(-a);
      b = exp(-b);
    }
    sum = dot(a, vec4(1.0)) + dot(b, vec4(1.0));
  } else {
    const vec3 w = normalize(vec3(own, 0.3, 1.0));
    vec3 center = vec3(own, 0.2, 2.0);
    for (int i = 0; i < count; ++i) {
      center.x = center.x * 0.999 + 1e-3;
      const LineProfile line = line_profile(center, w, 1.5);
      const float weight = exp(-line.e);
      float previous_erf = erf_fast(1.5 * (1.0 - line.t0));
      for (int k = 1; k <= peak_slices; ++k) {
        const float current_erf = erf_fast(1.5 * (1.0 + 0.5 * float(k) - line.t0));
        sum += float(k) * weight * (current_erf - previous_erf);
        previous_erf = current_erf;
      }
    }
  }
  results[id] = sum;
}
