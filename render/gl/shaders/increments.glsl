// The optical depth of Gaussians on `chunk` slices of a ray at a time, in registers: see
// accumulate_increments() in render/optical_depth/increment_kernels.h. The including shader declares the shared
// nearest[] and farthest[], ascending: between them each boundary of all rays of the group is.
#include "formulas.glsl"

#ifdef OPTICS
const int chunk = slice_chunk / 2;  // more is kept of each
#else
const int chunk = slice_chunk;
#endif
#pragma optionNV(unroll all)

// The slices [x, y) of the chunk at `first` that [from, to] touches, of slices before `last`.
ivec2 touched_slices(float begin, float end, int first, int last) {
  ivec2 range = ivec2(0);
  const int count = min(chunk, last - first);
  for (int k = 0; k < count; ++k) {
    if (farthest[first + k + 1] <= begin) range.x = k + 1;
    if (nearest[first + k] < end) range.y = k + 1;
  }
  return range;
}

// The part of a Gaussian's moment that depends on where it is cut, see Increments() on the host.
float cut_moment(float u, float a) { return inv_sqrt_pi * exp(-u * u) / a; }

// `ends`: where the slices of the chunk begin and end on this ray. `moments`: increments times the
// mean distance at which they lie.
void add_increments(inout float increments[chunk], inout float moments[chunk], LineProfile line,
                    float scale, float ends[chunk + 1], ivec2 range) {
  const float a = line.a;
  if (scale > exact_above) {
    float u_begin = a * (ends[0] - line.t0);
    for (int k = 0; k < chunk; ++k) {
      const float u_end = a * (ends[k + 1] - line.t0);
      if (k >= range.x && k < range.y) {
        const float depth = scale * segment_integral(line.e, u_begin, u_end, u_end - u_begin);
        increments[k] += depth;
        moments[k] += depth * 0.5 * (ends[k] + ends[k + 1]);
      }
      u_begin = u_end;
    }
    return;
  }
  const float weight = scale * exp(-line.e);
  const float u_first = a * (ends[0] - line.t0);
  float previous_erf = erf_fast(u_first);
  float previous_moment = cut_moment(u_first, a);
  float previous_u = u_first;
  for (int k = 0; k < chunk; ++k) {
    const float u = a * (ends[k + 1] - line.t0);
    const float current_erf = erf_fast(u);
    const float current_moment = cut_moment(u, a);
    const float depth = k >= range.x && k < range.y ? weight * (current_erf - previous_erf) : 0.0;
    increments[k] += depth;
    if (u - previous_u < short_slice) {
      moments[k] += depth * 0.5 * (ends[k] + ends[k + 1]);
    } else if (k >= range.x && k < range.y) {
      moments[k] += depth * line.t0 + weight * (previous_moment - current_moment);
    }
    previous_u = u;
    previous_erf = current_erf;
    previous_moment = current_moment;
  }
}
