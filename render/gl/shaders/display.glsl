// Converts a frame for the screen, as to_display() of render/display does. In a medium that
// absorbs, which colour channels may take part in different frames, each adds its own; the last one
// shows them: see render/prepare/albedo.
#include "constants.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(rgba32f, binding = 0) readonly uniform image2D airlight;
layout(rgba32f, binding = 1) readonly uniform image2D beauty;
layout(rgba32f, binding = 2) uniform image2D channels_so_far;
layout(rgba8, binding = 3) writeonly uniform image2D picture;  // rows from the bottom

uniform float albedo;
uniform vec3 channels;  // 1: it is of this frame
uniform bool airlight_only;
uniform bool is_first;
uniform bool is_last;
uniform float gain;
uniform ivec2 first_pixel;

const float max_byte = 255.0;

vec3 compress_highlights(vec3 c) {
  const float low = min(c.r, min(c.g, c.b));
  c -= low < highlight_knee ? low - highlight_slope * low * low : highlight_offset;
  const float peak = max(c.r, max(c.g, c.b));
  if (peak < highlight_start) return c;
  const float room = 1.0 - highlight_start;
  const float new_peak = 1.0 - room * room / (peak + room - highlight_start);
  const float white = 1.0 - 1.0 / (highlight_desaturation * (peak - new_peak) + 1.0);
  return mix(c * (new_peak / peak), vec3(new_peak), white);
}

vec3 srgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(srgb_gain * pow(c, vec3(1.0 / srgb_exponent)) - srgb_offset, srgb_slope * c,
             lessThanEqual(c, vec3(srgb_knee)));
}

// See render/display/dither.h.
float dither_threshold(uvec2 place) {
  const uint n = place.x * dither_column_step + place.y * dither_row_step;
  return (float(n >> (32u - dither_threshold_bits)) + 0.5) * dither_threshold_unit;
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  const ivec2 film = imageSize(picture);
  if (any(greaterThanEqual(pixel, film))) return;
  const vec3 of_medium = imageLoad(airlight, pixel).rgb;
  vec3 c = albedo * of_medium;
  if (!airlight_only) c += max(imageLoad(beauty, pixel).rgb - of_medium, 0.0);
  if (!is_first) c = mix(imageLoad(channels_so_far, pixel).rgb, c, channels);
  if (!is_last) {
    imageStore(channels_so_far, pixel, vec4(c, 1.0));
    return;
  }
  c = srgb(compress_highlights(clamp(gain * c, 0.0, brightest_shown)));
  c = floor(max_byte * c + dither_threshold(uvec2(first_pixel + pixel))) / max_byte;
  imageStore(picture, ivec2(pixel.x, film.y - 1 - pixel.y), vec4(c, 1.0));
}
