// T(s, x) of the Gaussians around one light over directions and radii: OpticalDepthTable on the
// device. A work group makes `bundle_side`^2 neighbouring directions, each along one ray, of the
// Gaussians that touch the cone around its rays.
#include "constants.glsl"

layout(local_size_x = bundle_size) in;

shared float nearest[max_table_radii];  // all rays have the same boundaries
#define farthest nearest

#include "cone.glsl"
#include "direction_map.glsl"
#include "ellipsoids.glsl"
#include "increments.glsl"
#include "compact.glsl"

layout(std430, binding = 0) restrict readonly buffer Centers { double centers[]; };
layout(std430, binding = 1) restrict readonly buffer Shapes { GaussianShape shapes[]; };
// Two neighbouring radii in each, in units of `max_depth`, so that a look-up reads one word.
layout(std430, binding = 2) restrict writeonly buffer Tables { uint tables[]; };
layout(std430, binding = 4) restrict buffer Totals { uint pairs; };

uniform uint count;
uniform dvec3 light;
uniform DirectionMap map;
uniform int radii;
uniform float max_depth;
uniform float first_radius;
uniform float radii_per_unit;
uniform float curvature;  // see TableRadii

shared vec4 gaussians[bundle_size];
shared GaussianShape shapes_of[bundle_size];
#ifdef ELLIPSOIDS
shared EllipsoidWarp ellipsoids_of[bundle_size];
#endif
shared ivec2 ranges[bundle_size];
shared uint counted[bundle_size];  // 1 in the first chunk that it touches

void main() {
  const uint id = gl_LocalInvocationID.x;
  const ivec2 cells = map.cells.xy + 2;
  const ivec2 wanted = place_in_bundle();
  const bool live = all(lessThan(wanted, cells));
  const ivec2 cell = min(wanted, cells - 1);
  const vec3 w = vec3(map_direction(map, cell - 1));
  directions[id] = w;
  for (int k = int(id); k < radii; k += bundle_size) {
    nearest[k] = first_radius + float(k) / (radii_per_unit - curvature * float(k));
  }
  barrier();
  if (id == 0u) find_cone();

  const int last = radii - 1;
  const int place = map.cells.z + (cell.y * cells.x + cell.x) * radii;
  float depth = 0.0;
  float before = 0.0;
  uint evaluated = 0u;
  for (int first = 0; first < last; first += chunk) {
    float increments[chunk];
    float moments[chunk];  // of no use here
    float ends[chunk + 1];
    for (int k = 0; k < chunk; ++k) increments[k] = moments[k] = 0.0;
    for (int k = 0; k <= chunk; ++k) ends[k] = nearest[min(first + k, last)];
    for (uint base = 0u; base < count; base += uint(bundle_size)) {
      barrier();  // what the group has found before is read below
      const uint i = base + id;
      GaussianShape shape = GaussianShape(0.0, 0.0, 0.0, 0.0);
      vec3 b = vec3(0.0);
      ivec2 range = ivec2(0);
      bool matters = i < count;
      if (matters) {
        shape = shapes[i];
        b = vec3(dvec3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]) - light);
        range = touched_slices(length(b) - shape.cutoff_radius, length(b) + shape.cutoff_radius, first, last);
        matters = shape.cutoff_radius > 0.0 && range.x < range.y &&
                  touches_cone(b, shape.cutoff_radius);
      }
      uint found;
      const uint slot = compact_slot(matters, found);
      if (matters) {
        gaussians[slot] = vec4(b, shape.a);
        shapes_of[slot] = shape;
#ifdef ELLIPSOIDS
        ellipsoids_of[slot] = ellipsoid_of(i);
#endif
        ranges[slot] = range;
        counted[slot] = first == 0 || length(b) - shape.cutoff_radius > nearest[first] ? 1u : 0u;
      }
      barrier();
      for (uint j = 0u; j < found; ++j) {
        const vec4 g = gaussians[j];
#ifdef ELLIPSOIDS
        const LineProfile line = line_profile(ellipsoids_of[j], g.xyz, w, g.w);
#else
        const LineProfile line = line_profile(g.xyz, w, g.w);
#endif
        if (line.e > shapes_of[j].max_e) continue;
        evaluated += counted[j];
        add_increments(increments, moments, line, half_depth_of(line, shapes_of[j].scale, g.w), ends, ranges[j]);
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
