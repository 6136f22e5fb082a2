// Optical depths from lights to surface points: bundle_depths() of render/cpu. One work group per 8
// x 8 pixels; it culls Gaussians against the cone of its paths.
#include "cone.glsl"
#include "gaussian.glsl"
#include "surface_point.glsl"

layout(local_size_x = 64) in;
#include "compact.glsl"

layout(std430, binding = 0) readonly buffer Centers { double centers[]; };
layout(std430, binding = 1) readonly buffer Shapes { vec4 shapes[]; };  // a, scale, cutoff, reach
layout(std430, binding = 3) writeonly buffer Depths { float depths[]; };
layout(std430, binding = 6) buffer Totals { uint pairs; };

uniform uint count;
uniform dvec3 light;
uniform vec3 light_at;  // relative to the middle of the surfaces
uniform ivec2 film;
uniform int first;  // where the light's depths begin

shared uint longest;  // path, as bits: floats >= 0 are in the order of their bits
shared vec4 gaussians[64];
shared vec2 shapes_of[64];  // scale, cutoff

void main() {
  const uint id = gl_LocalInvocationID.x;
  const ivec2 wanted = ivec2(gl_WorkGroupID.xy) * 8 + ivec2(id % 8u, id / 8u);
  const ivec2 pixel = min(wanted, film - 1);
  const int index = pixel.y * film.x + pixel.x;
  const ivec4 hit = hits[index];
  const bool live = all(lessThan(wanted, film)) && hit.w >= 0;
  const vec3 q = live ? hit_position(hit) - light_at : vec3(0.0);
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
  for (uint base = 0u; base < count && end > 0.0; base += 64u) {
    barrier();  // what the group has found before is read below
    const uint i = base + id;
    vec4 shape = vec4(0.0);
    vec3 b = vec3(0.0);
    bool matters = i < count;
    if (matters) {
      shape = shapes[i];
      b = vec3(dvec3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]) - light);
      matters = shape.w > 0.0 && length(b) - shape.w <= end && touches_cone(b, shape.w);
    }
    uint found;
    const uint slot = compact_slot(matters, found);
    if (matters) {
      gaussians[slot] = vec4(b, shape.x);
      shapes_of[slot] = shape.yz;
    }
    barrier();
    for (uint j = 0u; j < found && length_ > 0.0; ++j) {
      const vec4 g = gaussians[j];
      const Crossing crossing = crossing_of(g.xyz, w, g.w);
      if (crossing.e > shapes_of[j].y) continue;
      ++evaluated;
      depth += shapes_of[j].x * crossing_depth(crossing, g.w, length_);
    }
  }
  if (live) {
    depths[first + index] = depth;
    atomicAdd(pairs, evaluated);
  }
}
