// The line integral of a Gaussian: render/simd/gaussian-inl.h in GLSL. Rays that hit nothing end at
// `endless`, not infinity, so sums stay finite.
#include "constants.glsl"

// Nothing is left of erfc beyond this, where squares are still floats.
const float erfc_end = 1e4;

float erfcx_positive(float x) {
  const float t = 1.0 / (0.5 * x + 1.0);
  float p = erfcx_coefficients[0];
  for (int i = 1; i < erfcx_coefficients.length(); ++i) p = p * t + erfcx_coefficients[i];
  return t * p;
}

float erf_small(float x) {
  const float y = x * x;
  float p = erf_small_coefficients[0];
  for (int i = 1; i < erf_small_coefficients.length(); ++i) p = p * y + erf_small_coefficients[i];
  return x * p;
}

float erf_fast(float x) {
  const float z = clamp(x, -erf_fast_end, erf_fast_end);
  const float y = z * z;
  float p = erf_fast_coefficients[0];
  for (int i = 1; i < erf_fast_coefficients.length(); ++i) p = p * y + erf_fast_coefficients[i];
  return z * p;
}

// exp(-e) erfc(|u|).
float scaled_erfc(float e, float u) {
  const float x = min(abs(u), erfc_end);
  return exp(-(x * x + e)) * erfcx_positive(x);
}

// exp(-e) (erf(u1) - erf(u0)), u0 <= u1, k = u1 - u0 without cancellation.
float segment_integral(float e, float u0, float u1, float k) {
  const float steepness = 1.0 + abs(u0) + abs(u1);
  if (k * steepness < 1.0) {
    const float m = 0.5 * (u0 + u1);
    float mean = 0.0;
    for (int i = 0; i < gauss_nodes.length(); ++i) {
      const float s = 0.5 * gauss_nodes[i] * k;
      const float low = m - s;
      const float high = m + s;
      mean += gauss_weights[i] * (exp(-(low * low + e)) + exp(-(high * high + e)));
    }
    return inv_sqrt_pi * k * mean;
  }
  const float first = scaled_erfc(e, u0);
  const float second = scaled_erfc(e, u1);
  if (u0 <= 0.0 && u1 >= 0.0) {
    const float full_line_half = exp(-e);
    return full_line_half + full_line_half - first - second;
  }
  return abs(first - second);
}

// A Gaussian of center b relative to a line through the origin: LineProfile of core/transport.
struct LineProfile {
  float t0;
  float e;
  float a;
  float share;  // of the depth of the longest line through the Gaussian, for one in this direction
};

LineProfile line_profile(vec3 b, vec3 w, float a) {
  const float t0 = dot(b, w);
  const vec3 q = a * (b - t0 * w);
  return LineProfile(t0, dot(q, q), a, 1.0);
}

// Of an ellipsoid: b and w warped, a that of its greatest radius.
LineProfile warped_line_profile(vec3 b, vec3 w, float a) {
  const float speed2 = dot(w, w);
  const float t0 = dot(b, w) / speed2;
  const vec3 q = a * (b - t0 * w);
  const float speed = sqrt(speed2);
  return LineProfile(t0, dot(q, q), a * speed, 1.0 / speed);
}

// Optical depth over [0, length] in units of c sqrt(pi) / (2 line.a).
float unit_depth(LineProfile line, float length_) {
  return segment_integral(line.e, -line.a * line.t0, line.a * (length_ - line.t0), line.a * length_);
}

float henyey_greenstein(float cos_theta, float g) {
  const float s = 1.0 + g * g - 2.0 * g * cos_theta;
  return (1.0 - g * g) / (s * sqrt(s));
}

float cos_theta(float along, float distance_) { return -along / max(distance_, tiny); }
