// Tables over directions: DirectionMap of render/geometry, and MapPosition of
// render/slices/slice_kernels.cpp.
#include "formulas.glsl"
#include "structs.glsl"

int map_stride(DirectionMap map) { return map.cells.x + 2; }

struct MapPosition {
  int cell;  // the lower of the cells to mix
  vec2 f;    // and by how much
};

vec2 sign_of(vec2 p) { return vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0); }

// The position of q from a point whose components in a perspective map are `origin`; `distance_`:
// from the light.
MapPosition map_position(DirectionMap map, vec3 q, vec3 origin, float distance_) {
  vec2 uv;
  if (map.axis.w > 0.5) {
    uv = octahedral_position(q);
  } else {
    // Behind the light there is nothing of interest; clamped to the map's border texel.
    const float depth = max(max(dot(q, map.axis.xyz) + origin.z, min_map_cosine * distance_), tiny);
    uv = vec2(dot(q, map.right.xyz) + origin.x, dot(q, map.up.xyz) + origin.y) / depth *
             vec2(map.right.w, map.up.w) +
         map.offset.xy;
  }
  const vec2 cells = vec2(map.cells.xy);
  const vec2 coordinate =
      clamp(0.5 * cells * uv + 0.5 * cells + 0.5, vec2(0.0), cells + map_border_share);
  const ivec2 low = ivec2(coordinate);
  return MapPosition(low.y * map_stride(map) + low.x, coordinate - vec2(low));
}

// The unit direction of the middle of a cell; -1, columns and rows are the border.
dvec3 map_direction(DirectionMap map, ivec2 cell) {
  vec2 uv = (2.0 * vec2(cell) + 1.0) / vec2(map.cells.xy) - 1.0;
  if (map.axis.w < 0.5) {
    uv = (uv - map.offset.xy) / vec2(map.right.w, map.up.w);
    // Floats are too coarse for far lights.
    return normalize(dvec3(map.axis.xyz) + double(uv.x) * dvec3(map.right.xyz) +
                     double(uv.y) * dvec3(map.up.xyz));
  }
  // Over the border of the map the octahedron folds back.
  if (abs(uv.x) > 1.0) uv = vec2((uv.x < 0.0 ? -2.0 : 2.0) - uv.x, -uv.y);
  if (abs(uv.y) > 1.0) uv = vec2(-uv.x, (uv.y < 0.0 ? -2.0 : 2.0) - uv.y);
  vec3 d = vec3(uv, 1.0 - abs(uv.x) - abs(uv.y));
  if (d.z < 0.0) d.xy = (1.0 - abs(uv.yx)) * sign_of(uv);
  return dvec3(normalize(d));
}
