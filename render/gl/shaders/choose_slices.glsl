// Slice boundaries per tile: FilmSlices::choose(). One work group per tile.
#include "constants.glsl"
#include "tile_list.glsl"
#include "linear.glsl"
#include "rays.glsl"
#include "lights.glsl"
#include "view_fog.glsl"
#include "slice_boundaries.glsl"

layout(r32f, binding = 0) readonly uniform image2D depths;  // to the surface; < 0: none
// For each tile: the number of its boundaries, and room for `stride` of them.
layout(std430, binding = 5) restrict writeonly buffer Chosen { float chosen[]; };

uniform ivec2 film;
uniform ivec2 tiles;
uniform int scale;
uniform float ray_end;  // of rays that hit nothing
uniform int slices;
uniform int per_light;
uniform int stride;

// The pixels [x, z) x [y, w) that a tile's samples cover: FilmTiles::pixels().
ivec4 pixels_of(ivec2 tile) {
  const ivec2 begin = tile * ivec2(tile_width, tile_height) * scale;
  const ivec2 end = begin + ivec2(tile_width, tile_height) * scale;
  return ivec4(min(begin, film - 1), mix(film, end, lessThan(end + 1, film)));
}

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int tile = int(linear_group());
  if (tile >= tiles.x * tiles.y) return;  // uniform within the group
  const ivec4 pixels = pixels_of(ivec2(tile % tiles.x, tile / tiles.x));
  const ivec2 size = pixels.zw - pixels.xy;
  const ivec2 corner_ = ivec2(id & 1, id >> 1 & 1) * (size - 1);
  float max_length = 0.0;
  for (int i = id; i < size.x * size.y; i += group_size) {
    const float depth = imageLoad(depths, pixels.xy + ivec2(i % size.x, i / size.x)).r;
    max_length = max(max_length, depth >= 0.0 ? depth : ray_end);
  }
  const bool is_corner = id < 4;
  set_ray_offset(pixels.xy + corner_);
  CenterRay ray = center_ray(is_corner, ray_direction(pixels.xy + corner_));
  ray.max_length = reduce_max(max_length);
  choose_slices(ray, offsets[tile], offsets[tile + 1], slices, per_light);
  barrier();
  const int count = boundary_count < 2 ? 0 : min(boundary_count, stride);
  const int first = tile * (stride + 1);
  if (id == 0) chosen[first] = float(count);
  for (int k = id; k < count; k += group_size) chosen[first + 1 + k] = boundaries[k];
}
