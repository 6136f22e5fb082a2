// Fills curved cells between pixels that are two apart: fill_halved_cells() of
// render/cpu/halved_cells.h, for one tile, after interpolate.glsl. Lists the pixels that remain.
#include "upsampling.glsl"

layout(rgba32f, binding = 1) readonly uniform image2D nodes;  // the airlight image

// A quarter of a cell: 2 x 2 pixels between four nodes, and those in line with them.
bool is_linear(ivec2 cell, ivec2 quarter) {
  bool linear = true;
  for (int k = 0; k < 2; ++k) {
    const ivec2 row = cell + ivec2(0, 2 * (quarter.y + k));
    const ivec2 column = cell + ivec2(2 * (quarter.x + k), 0);
    linear = linear &&
             curvature_of(imageLoad(nodes, row), imageLoad(nodes, row + ivec2(2, 0)),
                          imageLoad(nodes, row + ivec2(4, 0))) <= 1.0 &&
             curvature_of(imageLoad(nodes, column), imageLoad(nodes, column + ivec2(0, 2)),
                          imageLoad(nodes, column + ivec2(0, 4))) <= 1.0;
  }
  return linear;
}

// A bit mask of pixels to evaluate exactly.
uint fill(ivec2 cell, uint curved, float tolerance_u) {
  uint remaining = 0u;
  for (int part = 0; part < 4; ++part) {
    const ivec2 quarter = ivec2(part & 1, part >> 1);
    const ivec2 first = cell + 2 * quarter;
    const bool linear = is_linear(cell, quarter);
    const vec4 v00 = imageLoad(nodes, first);
    const vec4 v10 = imageLoad(nodes, first + ivec2(2, 0));
    const vec4 v01 = imageLoad(nodes, first + ivec2(0, 2));
    const vec4 v11 = imageLoad(nodes, first + 2);
    const vec4 t = vec4(distance_at(first), distance_at(first + ivec2(2, 0)),
                        distance_at(first + ivec2(0, 2)), distance_at(first + 2));
    for (int k = 1; k < 4; ++k) {
      const ivec2 place = 2 * quarter + ivec2(k & 1, k >> 1);
      const uint bit = 1u << (4 * place.y + place.x);
      if ((curved & bit) == 0u) continue;
      const ivec2 pixel = cell + place;
      const vec2 f = 0.5 * vec2(k & 1, k >> 1);
      const float expected = mix(mix(t.x, t.y, f.x), mix(t.z, t.w, f.x), f.y);
      const float found = distance_at(pixel);
      const bool lies_between = (curved & curved_is_open) != 0u
                                    ? found >= endless
                                    : abs(found - expected) <= tolerance_u;
      if (linear && lies_between) {
        imageStore(airlight_image, pixel, mix(mix(v00, v10, f.x), mix(v01, v11, f.x), f.y));
      } else {
        remaining |= bit;
      }
    }
  }
  return remaining;
}

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int tile = int(linear_group());
  if (tile >= tiles.x * tiles.y) return;  // uniform within the group
  const ivec2 cell = (ivec2(tile % tiles.x, tile / tiles.x) * ivec2(tile_width, tile_height) +
                      ivec2(id % tile_width, id / tile_width)) *
                     scale;
  const uint curved = curved_cells[tile * group_size + id];
  const bool is_cell = (curved & curved_is_cell) != 0u;
  const float tolerance_u = distance_tolerance(tile);
  list_requests(tile, is_cell ? fill(cell, curved, tolerance_u) : 0u, cell, 4);
}
