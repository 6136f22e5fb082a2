// Compositing, eq. 29: airlight + transmittance * background. Background: outgoing radiance of
// surfaces, or the environment; see behind_medium() of render/cpu/composite.
#include "constants.glsl"
#include "radiance_map.glsl"
#include "rays.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(rgba32f, binding = 0) readonly uniform image2D airlight;  // RGB, transmittance
layout(rgba32f, binding = 1) writeonly uniform image2D beauty;
layout(r32f, binding = 2) readonly uniform image2D depths;  // to the surface; < 0: none
layout(std430, binding = 0) restrict readonly buffer Sky { vec4 sky[]; };
layout(std430, binding = 1) restrict readonly buffer Behind { vec4 behind[]; };  // RGB of surfaces

#ifdef HOLDOUTS
#include "corners.glsl"
layout(std430, binding = 2) restrict readonly buffer Hits { PixelHit hits[]; };
layout(std430, binding = 3) restrict readonly buffer HeldOut { uint held_out[]; };  // per surface

bool is_held_out(int pixel) { return held_out[corners[3 * hits[pixel].triangle].index] != 0u; }
#else
bool is_held_out(int pixel) { return false; }
#endif

uniform ivec2 film;
uniform ivec2 sky_size;  // 0: there is none
uniform vec2 sky_rotation;
uniform float sky_intensity;

vec3 sky_radiance(vec3 w) {
  const MapTexels texels = map_texels(sky_size, turned_to_map(sky_rotation, w));
  const vec3 above = mix(sky[texels.index.x].rgb, sky[texels.index.y].rgb, texels.f.x);
  const vec3 below = mix(sky[texels.index.z].rgb, sky[texels.index.w].rgb, texels.f.x);
  return sky_intensity * mix(above, below, texels.f.y);
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, film))) return;
  const vec4 medium = imageLoad(airlight, pixel);
  const bool on_surface = imageLoad(depths, pixel).r >= 0.0;
  const int index = pixel.y * film.x + pixel.x;
  const bool is_solid = on_surface && !is_held_out(index);
  vec3 radiance = is_solid ? behind[index].rgb : vec3(0.0);
  if (!on_surface && sky_size.x > 0) radiance = sky_radiance(ray_direction(pixel));
  // No brighter than a float may be, or black fog would make NaN of it.
  radiance = medium.rgb + medium.a * min(radiance, vec3(max_radiance));
  imageStore(beauty, pixel,
             vec4(clamp(radiance, vec3(0.0), vec3(max_radiance)), is_solid ? 1.0 : 1.0 - medium.a));
}
