// Sums the pairs of each row of pixels.
layout(local_size_x = 64) in;

layout(r32f, binding = 0) readonly uniform image2D pairs;
layout(std430, binding = 0) restrict writeonly buffer Rows { float rows[]; };

uniform int width;

shared float sums[gl_WorkGroupSize.x];

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int y = int(gl_WorkGroupID.x);
  float sum = 0.0;
  for (int x = id; x < width; x += int(gl_WorkGroupSize.x))
    sum += imageLoad(pairs, ivec2(x, y)).r;
  sums[id] = sum;
  for (int half_ = int(gl_WorkGroupSize.x) / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (id < half_) sums[id] += sums[id + half_];
  }
  if (id == 0) rows[y] = sums[0];
}
