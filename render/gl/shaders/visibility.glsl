// The first surface on each view ray: RayCaster::first_hits() of
// render/visibility.
#include "rays.glsl"
#include "trace.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32f, binding = 0) writeonly uniform image2D depths;  // to the surface; < 0: none
layout(std430, binding = 2) restrict writeonly buffer Hits { PixelHit hits[]; };

uniform dvec3 eye;
uniform ivec2 film;

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, film))) return;
  double skip;
  const Hit hit = first_hit(eye + exact_offset(pixel), exact_direction(pixel), 0.0, skip);
  const float t = hit.triangle < 0 ? -1.0 : float(skip + hit.t);
  imageStore(depths, pixel, vec4(t));
  hits[pixel.y * film.x + pixel.x] = PixelHit(t, hit.u, hit.v, hit.triangle);
}
