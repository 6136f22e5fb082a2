// The optical depth of Gaussians on `chunk` slices of a ray at a time, in registers: see
// accumulate_increments() in render/lighting/slice_kernels.h. The including shader declares the shared
// nearest[] and farthest[], ascending: between them each boundary of all rays of the group is.
#include "gaussian.glsl"
#pragma optionNV(unroll all)

// The slices [x, y) of the chunk at `first` that [from, to] touches, of slices before `last`.
ivec2 touched_slices(float begin, float to, int first, int last) {
  ivec2 range = ivec2(0);
  const int count = min(chunk, last - first);
  for (int k = 0; k < count; ++k) {
    if (farthest[first + k + 1] <= begin) range.x = k + 1;
    if (nearest[first + k] < to) range.y = k + 1;
  }
  return range;
}

// `ends`: where the slices of the chunk begin and end on this ray.
void add_increments(inout float increments[chunk], Crossing crossing, float a, float scale,
                    float ends[chunk + 1], ivec2 range) {
  if (scale > exact_above) {
    float before = a * (ends[0] - crossing.t0);
    for (int k = 0; k < chunk; ++k) {
      const float now = a * (ends[k + 1] - crossing.t0);
      if (k >= range.x && k < range.y) {
        increments[k] += scale * segment_integral(crossing.e, before, now, now - before);
      }
      before = now;
    }
    return;
  }
  const float weight = scale * exp(-crossing.e);
  float before = erf_fast(a * (ends[0] - crossing.t0));
  for (int k = 0; k < chunk; ++k) {
    const float now = erf_fast(a * (ends[k + 1] - crossing.t0));
    increments[k] += k >= range.x && k < range.y ? weight * (now - before) : 0.0;
    before = now;
  }
}
