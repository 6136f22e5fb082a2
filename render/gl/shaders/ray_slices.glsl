// The slices of rays between the nodes of their tile: RaySlices of render/lighting.
#include "slice_nodes.glsl"

layout(r32f, binding = 4) readonly uniform image2D slice_nodes;

uniform int stride;

shared float nearest[max_boundaries];  // of all rays of the group
shared float farthest[max_boundaries];
shared int boundary_count;

float node_value(int place) { return imageLoad(slice_nodes, node_texel(place)).r; }

int node_position(ivec2 node) { return (node.y * (2 * tiles.x + 1) + node.x) * (stride + 1); }

// Computed by the whole group: nearest, farthest and number; 0 without medium.
void find_slice_bounds(int tile) {
  const int id = int(gl_LocalInvocationID.x);
  const ivec2 first = 2 * ivec2(tile % tiles.x, tile / tiles.x);
  int count = 0;
  for (int k = 0; k < 9; ++k) {
    count = max(count, int(node_value(node_position(first + ivec2(k % 3, k / 3)))));
  }
  // The node in the middle is the tile's alone.
  if (node_value(node_position(first + 1)) == 0.0) count = 0;
  for (int k = id; k < count; k += group_size) {
    float low = endless;
    float high = 0.0;
    for (int n = 0; n < 9; ++n) {
      const float t = node_value(node_position(first + ivec2(n % 3, n / 3)) + 1 + k);
      low = min(low, t);
      high = max(high, t);
    }
    nearest[k] = low;
    farthest[k] = high;
  }
  if (id == 0) boundary_count = count;
  barrier();
}

// Position of a ray between four nodes.
struct SlicePosition {
  ivec4 nodes;  // row by row
  vec2 f;
};

SlicePosition slice_position(int tile, ivec2 pixel) {
  const ivec2 size = ivec2(tile_width, tile_height) * scale;
  const ivec2 tile_position = ivec2(tile % tiles.x, tile / tiles.x);
  // The last pixels of a film may lie slightly outside the tile.
  const vec2 position = 2.0 * clamp(vec2(pixel - tile_position * size) / vec2(size), 0.0, 1.0);
  const ivec2 cell = ivec2(greaterThanEqual(position, vec2(1.0)));
  const ivec2 first = 2 * tile_position + cell;
  return SlicePosition(ivec4(node_position(first), node_position(first + ivec2(1, 0)),
                          node_position(first + ivec2(0, 1)), node_position(first + 1)) + 1,
                    position - vec2(cell));
}

// Boundary k of a ray.
float slice_boundary(SlicePosition position, int k) {
  const float above = mix(node_value(position.nodes.x + k), node_value(position.nodes.y + k), position.f.x);
  const float below = mix(node_value(position.nodes.z + k), node_value(position.nodes.w + k), position.f.x);
  return mix(above, below, position.f.y);
}
