// Optical depths from lights to surface points: bundle_depths() of render/lighting. One work group per
// `bundle_side`^2 pixels; it culls Gaussians against the cone of its paths.
#include "cone.glsl"
#include "formulas.glsl"
#include "ellipsoids.glsl"
#include "surface_point.glsl"

layout(local_size_x = bundle_size) in;
#include "compact.glsl"

layout(std430, binding = 0) restrict readonly buffer Centers { double centers[]; };
layout(std430, binding = 1) restrict readonly buffer Shapes { GaussianShape shapes[]; };
layout(std430, binding = 3) restrict writeonly buffer Depths { float depths[]; };
layout(std430, binding = 6) restrict buffer Totals { uint pairs; };

uniform uint count;
uniform dvec3 light;
uniform vec3 light_at;  // relative to the middle of the surfaces
uniform ivec2 film;
uniform int first;  // where the light's depths begin

shared uint longest;  // path, as bits: floats >= 0 are in the order of their bits
shared vec4 gaussians[bundle_size];
shared GaussianShape shapes_of[bundle_size];
#ifdef ELLIPSOIDS
shared EllipsoidWarp ellipsoids_of[bundle_size];
#endif

void main() {
  const uint id = gl_LocalInvocationID.x;
  const ivec2 wanted = place_in_bundle();
  const ivec2 pixel = min(wanted, film - 1);
  const int index = pixel.y * film.x + pixel.x;
  const PixelHit hit = hits[index];
  const bool live = all(lessThan(wanted, film)) && hit.triangle >= 0;
  const vec3 q = live ? hit_position(hit, pixel) - light_at : vec3(0.0);
  const float length_ = length(q);
  const vec3 w = length_ > 0.0 ? q / length_ : vec3(0.0);
  directions[id] = w;
  if (id == 0u) longest = 0u;
  barrier();
  atomicMax(longest, floatBitsToUint(length_));
  if (id == 0u) find_cone();
  barrier();

  float depth = 0.0;
  uint evaluated = 0u;
  const float end = uintBitsToFloat(longest);
  for (uint base = 0u; base < count && end > 0.0; base += uint(bundle_size)) {
    barrier();  // what the group has found before is read below
    const uint i = base + id;
    GaussianShape shape = GaussianShape(0.0, 0.0, 0.0, 0.0);
    vec3 b = vec3(0.0);
    bool matters = i < count;
    if (matters) {
      shape = shapes[i];
      b = vec3(dvec3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]) - light);
      matters = shape.cutoff_radius > 0.0 && length(b) - shape.cutoff_radius <= end &&
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
    }
    barrier();
    for (uint j = 0u; j < found && length_ > 0.0; ++j) {
      const vec4 g = gaussians[j];
#ifdef ELLIPSOIDS
      const LineProfile line = line_profile(ellipsoids_of[j], g.xyz, w, g.w);
#else
      const LineProfile line = line_profile(g.xyz, w, g.w);
#endif
      if (line.e > shapes_of[j].max_e) continue;
      ++evaluated;
      depth += half_depth_of(line, shapes_of[j].scale, g.w) * unit_depth(line, length_);
    }
  }
  if (live) {
    depths[first + index] = depth;
    atomicAdd(pairs, evaluated);
  }
}
