// Sorts the list of each tile, whose order is any after list.glsl: sums over Gaussians are to be the
// same in every frame. One work group per tile; a bitonic sort that only ever swaps upwards, so that
// any count does.
#include "linear.glsl"

layout(local_size_x = 256) in;

layout(std430, binding = 6) restrict coherent buffer Entries { uint list[]; };
layout(std430, binding = 7) restrict readonly buffer Offsets { uint offsets[]; };  // one more than tiles

uniform uint tiles;

const uint max_shared = 2048u;
shared uint values[max_shared];

void main() {
  const uint tile = linear_group();
  if (tile >= tiles) return;
  const uint begin = offsets[tile];
  const uint count = offsets[tile + 1u] - begin;
  const uint id = gl_LocalInvocationID.x;
  const uint step_ = gl_WorkGroupSize.x;
  const bool is_short = count <= max_shared;
  if (is_short) {
    for (uint i = id; i < count; i += step_) values[i] = list[begin + i];
  }
  for (uint run = 2u; run < 2u * count; run *= 2u) {
    for (uint distance_ = run / 2u; distance_ > 0u; distance_ /= 2u) {
      memoryBarrierBuffer();
      barrier();
      // The first round of a run compares with its mirror image, the others at a fixed distance.
      const uint mask = distance_ == run / 2u ? run - 1u : distance_;
      for (uint i = id; i < count; i += step_) {
        const uint other = i ^ mask;
        if (other <= i || other >= count) continue;
        const uint low = is_short ? values[i] : list[begin + i];
        const uint high = is_short ? values[other] : list[begin + other];
        if (low <= high) continue;
        if (is_short) {
          values[i] = high;
          values[other] = low;
        } else {
          list[begin + i] = high;
          list[begin + other] = low;
        }
      }
    }
  }
  barrier();
  if (is_short) {
    for (uint i = id; i < count; i += step_) list[begin + i] = values[i];
  }
}
