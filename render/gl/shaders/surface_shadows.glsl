// Which lights reach the surfaces that view rays meet. Apart from shading, whose registers leave
// room for few rays at a time: on an H200 the rays alone took as long as all else.
#include "lights.glsl"
#include "surface_point.glsl"
#include "trace.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// materials.glsl has written its findings here where METALLIC is defined.
layout(std430, binding = 3) restrict readonly buffer Behind { vec4 behind[]; };
// A bit per light; for each 32 lights a word per pixel.
layout(std430, binding = 6) restrict writeonly buffer Lit { uint lit[]; };

uniform ivec2 film;

bool is_lit(int l, SurfacePoint point) {
  const vec3 q = point.position - lights[l].position;
  const float length_ = length(q);
  if (!(length_ > 0.0) || !(dot(q, point.normal) < 0.0)) return false;
  const float end = 1.0 - light_margin -
      float(position_rounding) * max_component(abs(lights[l].position)) / length_;
  // Parametrised so that the light is at t = 1.
  const vec3 to_light = lights[l].position - point.shadow_origin;
  return trace(point.shadow_origin, to_light, 0.0, end, true).triangle < 0;
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, film))) return;
  const int pixels = film.x * film.y;
  const int index = pixel.y * film.x + pixel.x;
  const PixelHit hit = hits[index];
  if (hit.triangle < 0) return;
  SurfacePoint point = point_of(hit, pixel);
#ifdef METALLIC
  const vec4 found = behind[pixels + ggx_vectors * index];
  if (found.w > 0.0) point.normal = found.xyz;
#endif
  for (int first = 0; first < light_count; first += light_bits) {
    uint bits = 0u;
    for (int l = first; l < min(first + light_bits, light_count); ++l) {
      if (is_lit(l, point)) bits |= 1u << (l - first);
    }
    lit[first / light_bits * pixels + index] = bits;
  }
}
