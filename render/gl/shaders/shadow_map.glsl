// How far a light shines in the directions of a map before a surface stops it: ShadowMap of
// render/cpu.
#include "direction_map.glsl"
#include "trace.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 2) writeonly buffer Shadows { float shadows[]; };

uniform dvec3 light;
uniform float nearest;  // hit that counts
uniform vec4 map_right, map_up, map_axis, map_offset;
uniform ivec4 map_cells;

void main() {
  const ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  const ivec2 cells = map_cells.xy + 2;
  if (any(greaterThanEqual(cell, cells))) return;
  const DirectionMap map = DirectionMap(map_right, map_up, map_axis, map_offset, map_cells);
  float skip;
  const Hit hit = first_hit(light, dvec3(map_direction(map, cell - 1)), nearest, skip);
  // Nothing is farther than this; shaders know no infinity.
  shadows[map_cells.z + cell.y * cells.x + cell.x] =
      hit.triangle < 0 ? 1e30 : min(skip + hit.t, 1e30);
}
