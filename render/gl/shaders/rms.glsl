// The mean square of the airlight over all samples and channels, for interpolate.glsl.
#include "structs.glsl"

layout(local_size_x = 1024) in;

layout(rgba32f, binding = 1) readonly uniform image2D samples;
layout(std430, binding = 4) restrict buffer Totals { UpsamplingTotals totals; };

uniform ivec2 size;  // of the samples

shared float sums[gl_WorkGroupSize.x];

void main() {
  const int id = int(gl_LocalInvocationID.x);
  float sum = 0.0;
  for (int i = id; i < size.x * size.y; i += int(gl_WorkGroupSize.x)) {
    const vec3 value = imageLoad(samples, ivec2(i % size.x, i / size.x)).rgb;
    sum += dot(value, value) / (3.0 * float(size.x * size.y));
  }
  sums[id] = sum;
  for (int half_ = int(gl_WorkGroupSize.x) / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (id < half_) sums[id] += sums[id + half_];
  }
  if (id == 0) totals.mean_square = sums[0];
}
