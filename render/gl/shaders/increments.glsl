// The optical depth of Gaussians on `chunk` slices of a ray at a time, in registers: see
// accumulate_increments() in render/lighting/slice_kernels.h. The including shader declares the shared
// nearest[] and farthest[], ascending: between them each boundary of all rays of the group is.
#include "gaussian.glsl"

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

// `ends`: where the slices of the chunk begin and end on this ray.
void add_increments(inout float increments[chunk], LineProfile line, float a, float scale,
                    float ends[chunk + 1], ivec2 range) {
  if (scale > exact_above) {
    float u_begin = a * (ends[0] - line.t0);
    for (int k = 0; k < chunk; ++k) {
      const float u_end = a * (ends[k + 1] - line.t0);
      if (k >= range.x && k < range.y) {
        increments[k] += scale * segment_integral(line.e, u_begin, u_end, u_end - u_begin);
      }
      u_begin = u_end;
    }
    return;
  }
  const float weight = scale * exp(-line.e);
  float previous_erf = erf_fast(a * (ends[0] - line.t0));
  for (int k = 0; k < chunk; ++k) {
    const float current_erf = erf_fast(a * (ends[k + 1] - line.t0));
    increments[k] += k >= range.x && k < range.y ? weight * (current_erf - previous_erf) : 0.0;
    previous_erf = current_erf;
  }
}
