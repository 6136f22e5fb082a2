// Where the list of each tile begins: the running sum of what list.glsl has counted.
#include "structs.glsl"

layout(local_size_x = 1024) in;

layout(std430, binding = 4) restrict buffer Totals { TileTotals totals; };
layout(std430, binding = 5) restrict buffer Cursors { uint cursors[]; };
layout(std430, binding = 7) restrict writeonly buffer Offsets { uint offsets[]; };  // one more than tiles

uniform int tiles;

shared uint sums[gl_WorkGroupSize.x];

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int size = int(gl_WorkGroupSize.x);
  const int tiles_per_invocation = (tiles + size - 1) / size;
  const int begin = min(id * tiles_per_invocation, tiles);
  const int end = min(begin + tiles_per_invocation, tiles);
  uint sum = 0u;
  for (int i = begin; i < end; ++i) sum += cursors[i];
  sums[id] = sum;
  for (int step_ = 1; step_ < size; step_ *= 2) {
    barrier();
    const uint preceding = id >= step_ ? sums[id - step_] : 0u;
    barrier();
    sums[id] += preceding;
  }
  uint offset = sums[id] - sum;
  for (int i = begin; i < end; ++i) {
    const uint count = cursors[i];
    offsets[i] = offset;
    cursors[i] = offset;
    offset += count;
  }
  if (id == size - 1) {
    offsets[tiles] = sums[id];
    totals.entries = sums[id];
  }
}
