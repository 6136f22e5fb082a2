// T(s, x) of the Gaussians around one light over directions and radii: OpticalDepthTable on the device. A
// work group makes 8 x 8 neighbouring directions, each along one ray; its Gaussians it finds itself,
// those that touch the cone around its rays.
layout(local_size_x = 64) in;

const int max_radii = 1024;
shared float nearest[max_radii];  // all rays have the same boundaries
#define farthest nearest

#include "cone.glsl"
#include "direction_map.glsl"
#include "increments.glsl"
#include "compact.glsl"

layout(std430, binding = 0) readonly buffer Centers { double centers[]; };
layout(std430, binding = 1) readonly buffer Shapes { vec4 shapes[]; };  // a, scale, cutoff, reach
// Two neighbouring radii in each, in units of `max_depth`, so that a look-up reads one word.
layout(std430, binding = 2) writeonly buffer Tables { uint tables[]; };
layout(std430, binding = 4) buffer Totals { uint pairs; };

uniform uint count;
uniform dvec3 light;
uniform vec4 map_right, map_up, map_axis, map_offset;
uniform ivec4 map_cells;
uniform int radii;
uniform float max_depth;
uniform float first_radius;
uniform float radii_per_unit;
uniform float curvature;  // see TableRadii

shared vec4 gaussians[64];
shared vec4 shapes_of[64];
shared ivec2 ranges[64];
shared uint counted[64];  // 1 in the first chunk that it touches

void main() {
  const DirectionMap map = DirectionMap(map_right, map_up, map_axis, map_offset, map_cells);
  const uint id = gl_LocalInvocationID.x;
  const ivec2 cells = map_cells.xy + 2;
  const ivec2 wanted = ivec2(gl_WorkGroupID.xy) * 8 + ivec2(id % 8u, id / 8u);
  const bool live = all(lessThan(wanted, cells));
  const ivec2 cell = min(wanted, cells - 1);
  const vec3 w = map_direction(map, cell - 1);
  directions[id] = w;
  for (int k = int(id); k < radii; k += 64) {
    nearest[k] = first_radius + float(k) / (radii_per_unit - curvature * float(k));
  }
  barrier();
  if (id == 0u) find_cone();

  const int last = radii - 1;
  const int place = map_cells.z + (cell.y * cells.x + cell.x) * radii;
  float depth = 0.0;
  float before = 0.0;
  uint evaluated = 0u;
  for (int first = 0; first < last; first += chunk) {
    float increments[chunk];
    float ends[chunk + 1];
    for (int k = 0; k < chunk; ++k) increments[k] = 0.0;
    for (int k = 0; k <= chunk; ++k) ends[k] = nearest[min(first + k, last)];
    for (uint base = 0u; base < count; base += 64u) {
      barrier();  // what the group has found before is read below
      const uint i = base + id;
      vec4 shape = vec4(0.0);
      vec3 b = vec3(0.0);
      ivec2 range = ivec2(0);
      bool matters = i < count;
      if (matters) {
        shape = shapes[i];
        b = vec3(dvec3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]) - light);
        range = touched_slices(length(b) - shape.w, length(b) + shape.w, first, last);
        matters = shape.w > 0.0 && range.x < range.y && touches_cone(b, shape.w);
      }
      uint found;
      const uint slot = compact_slot(matters, found);
      if (matters) {
        gaussians[slot] = vec4(b, shape.x);
        shapes_of[slot] = shape;
        ranges[slot] = range;
        counted[slot] = first == 0 || length(b) - shape.w > nearest[first] ? 1u : 0u;
      }
      barrier();
      for (uint j = 0u; j < found; ++j) {
        const vec4 g = gaussians[j];
        const Crossing crossing = crossing_of(g.xyz, w, g.w);
        if (crossing.e > shapes_of[j].z) continue;
        evaluated += counted[j];
        add_increments(increments, crossing, g.w, shapes_of[j].y, ends, ranges[j]);
      }
    }
    // A word holds a radius and the next; so the first of a chunk ends the last one of the former.
    for (int k = 0; k < chunk; ++k) {
      if (first + k >= last) break;
      before = depth;
      depth += increments[k];
      if (live) {
        tables[place + first + k] = packUnorm2x16(vec2(before, depth) / max_depth);
      }
    }
  }
  if (live) atomicAdd(pairs, evaluated);
}
