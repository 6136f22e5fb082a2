// Merged slice boundaries at nodes: merge_slices() of render/cpu/film_slices.h. One work group per
// node.
#include "constants.glsl"
#include "linear.glsl"
#include "slice_nodes.glsl"

layout(local_size_x = group_size) in;

layout(r32f, binding = 4) writeonly uniform image2D slice_nodes;
layout(std430, binding = 5) restrict readonly buffer Chosen { float chosen[]; };  // see choose_slices.glsl

uniform ivec2 tiles;
uniform int stride;

shared float merged[4 * max_boundaries];

// How many of an ascending list are less than a value, or no greater.
int count_before(int first, int count, float value, bool or_equal) {
  int low = 0;
  int high = count;
  while (low < high) {
    const int center = (low + high) / 2;
    const float boundary = chosen[first + center];
    if (boundary < value || (or_equal && boundary == value)) {
      low = center + 1;
    } else {
      high = center;
    }
  }
  return low;
}

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int columns = 2 * tiles.x + 1;
  const int node = int(linear_group());
  if (node >= columns * (2 * tiles.y + 1)) return;  // uniform within the group
  const ivec2 node_position = ivec2(node % columns, node / columns);
  const ivec2 begin = max(node_position - 1, 0) / 2;
  const ivec2 end = min(node_position / 2, tiles - 1);
  int firsts[4];
  int counts[4];
  int lists = 0;
  int total = 0;
  for (int y = begin.y; y <= end.y; ++y) {
    for (int x = begin.x; x <= end.x; ++x) {
      const int first = (y * tiles.x + x) * (stride + 1);
      const int count = int(chosen[first]);
      if (count == 0) continue;
      firsts[lists] = first + 1;
      counts[lists++] = count;
      total += count;
    }
  }
  for (int j = 0; j < lists; ++j) {
    for (int i = id; i < counts[j]; i += group_size) {
      const float value = chosen[firsts[j] + i];
      int rank = i;
      for (int other = 0; other < lists; ++other) {
        if (other != j) rank += count_before(firsts[other], counts[other], value, other < j);
      }
      merged[rank] = value;
    }
  }
  barrier();
  const int count = lists > 0 ? (total + lists - 1) / lists : 0;
  const int first_value = node * (stride + 1);
  if (id == 0) imageStore(slice_nodes, node_texel(first_value), vec4(float(count)));
  for (int k = id; k < stride && lists > 0; k += group_size) {
    float value = 0.0;
    for (int j = 0; j < lists; ++j) value += merged[min(lists * k + j, total - 1)];
    value /= float(lists);
    if (k == 0) value = merged[0];
    if (k >= count - 1) value = merged[total - 1];
    imageStore(slice_nodes, node_texel(first_value + 1 + k), vec4(value));
  }
}
