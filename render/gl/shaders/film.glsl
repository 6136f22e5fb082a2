// The pixels that the work groups of an airlight method take, and where their results go.
#include "linear.glsl"
#include "rays.glsl"
#include "structs.glsl"

layout(r32f, binding = 0) readonly uniform image2D depths;  // to the surface; < 0: none
layout(rgba32f, binding = 1) writeonly uniform image2D samples;   // one for scale x scale pixels
layout(rgba32f, binding = 2) writeonly uniform image2D airlight_image;  // RGB, transmittance
layout(r32f, binding = 3) writeonly uniform image2D pairs_image;
// Requested exact pixels, x + y << 16, and their batches: PixelBatch.
layout(std430, binding = 5) restrict readonly buffer Requests { uint requests[]; };

uniform ivec2 film;
uniform ivec2 sample_film;
uniform ivec2 tiles;
uniform int scale;
uniform float ray_end;  // of rays that hit nothing
uniform int again;      // 1: pixels are those of `requests`
uniform int groups;     // of those that are to run
uniform int batches_at; // where groups begin in `requests`

struct PixelOfGroup {
  bool live;
  int tile;
  ivec2 position;
  ivec2 sample_position;
};

PixelOfGroup pixel_of_group() {
  const uint id = gl_LocalInvocationID.x;
  const uint group = linear_group();
  PixelOfGroup pixel;
  if (again != 0) {
    const uint batch = batches_at + batch_size * min(group, uint(groups - 1));
    pixel.tile = int(requests[batch + batch_tile]);
    pixel.live = group < uint(groups) && id < requests[batch + batch_count];
    const uint bits = requests[requests[batch + batch_first] + (pixel.live ? id : 0u)];
    pixel.position = ivec2(bits & 0xffffu, bits >> 16);
    pixel.sample_position = ivec2(0);
    return pixel;
  }
  pixel.tile = int(min(group, uint(groups - 1)));
  const ivec2 tile = ivec2(pixel.tile % tiles.x, pixel.tile / tiles.x);
  pixel.sample_position = tile * ivec2(tile_width, tile_height) + ivec2(id % tile_width, id / tile_width);
  pixel.live = group < uint(groups) && all(lessThan(pixel.sample_position, sample_film));
  pixel.position = min(pixel.sample_position * scale, film - 1);
  return pixel;
}

float ray_length(ivec2 pixel) {
  const float depth = imageLoad(depths, pixel).r;
  return depth >= 0.0 ? depth : ray_end;
}

float finite(float x) { return isnan(x) ? 0.0 : clamp(x, 0.0, max_radiance); }

void store_pixel(PixelOfGroup pixel, vec3 airlight, float depth, uint pairs) {
  if (!pixel.live) return;
  const vec4 value =
      vec4(finite(airlight.r), finite(airlight.g), finite(airlight.b), finite(exp(-depth)));
  if (again == 0) imageStore(samples, pixel.sample_position, value);
  imageStore(airlight_image, pixel.position, value);
  imageStore(pairs_image, pixel.position, vec4(float(pairs)));
}
