// Eq. 29: what is behind the medium, through it, and what the medium adds.

layout(local_size_x = 16, local_size_y = 8) in;

layout(rgba32f, binding = 0) readonly uniform image2D airlight;  // RGB, transmittance
layout(rgba32f, binding = 1) readonly uniform image2D behind;    // RGB, 1 where a surface is hit
layout(rgba32f, binding = 2) writeonly uniform image2D beauty;

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(beauty)))) return;
  const vec4 medium = imageLoad(airlight, pixel);
  const vec4 surface = imageLoad(behind, pixel);
  const vec3 radiance = clamp(medium.rgb + medium.a * surface.rgb, vec3(0.0), vec3(1e30));
  imageStore(beauty, pixel, vec4(radiance, surface.a > 0.5 ? 1.0 : 1.0 - medium.a));
}
