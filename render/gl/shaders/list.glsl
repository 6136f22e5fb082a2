// The lists of tiles: counts their entries, or fills them at the offsets of scan.glsl. Several
// invocations share a Gaussian. The order within a list is any until sort_list.glsl has sorted it.
#include "constants.glsl"
#include "linear.glsl"
#include "structs.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 3) restrict readonly buffer Rectangles { uvec2 rectangles[]; };
layout(std430, binding = 4) restrict readonly buffer Totals { TileTotals totals; };
layout(std430, binding = 5) restrict buffer Cursors { uint cursors[]; };  // per tile
layout(std430, binding = 6) restrict writeonly buffer Entries { uint list[]; };

uniform uint count;
uniform int columns;
uniform uint max_coarse;  // more would not fit
uniform int fill;          // 0: count

void main() {
  if (totals.coarse > max_coarse) return;
  const uint invocation = linear_group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  const uint i = invocation / invocations_per_gaussian;
  if (i >= count) return;
  const uvec2 bits = rectangles[i];
  const ivec2 begin = ivec2(bits.x & 0xffffu, bits.x >> 16);
  const ivec2 size = ivec2(bits.y & 0xffffu, bits.y >> 16) - begin;
  for (int k = int(invocation % invocations_per_gaussian); k < size.x * size.y;
       k += int(invocations_per_gaussian)) {
    const int tile = (begin.y + k / size.x) * columns + begin.x + k % size.x;
    const uint place = atomicAdd(cursors[tile], 1u);
    if (fill != 0) list[place] = i;
  }
}
