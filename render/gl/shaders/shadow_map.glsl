// How deep a light shines in the directions of a map before a surface stops it: ShadowMap of
// render/lighting.
#include "direction_map.glsl"
#include "trace.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 2) restrict writeonly buffer Shadows { float shadows[]; };

uniform dvec3 light;
uniform float nearest;  // hit that counts
uniform double start;   // shadow_start()
uniform DirectionMap map;

void main() {
  const ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  const ivec2 cells = map.cells.xy + 2;
  if (any(greaterThanEqual(cell, cells))) return;
  double skip;
  const dvec3 direction = map_direction(map, cell - 1);
  const Hit hit = first_hit(light, direction, nearest, skip);
  const double cosine = map.axis.w > 0.5 ? 1.0LF : dot(direction, dvec3(map.axis.xyz));
  // Nothing is farther than this; shaders know no infinity.
  shadows[map.cells.z + cell.y * cells.x + cell.x] =
      hit.triangle < 0 ? endless : min(float((skip + hit.t) * cosine - start), endless);
}
