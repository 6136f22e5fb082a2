// Metallic-roughness materials where view rays hit: find_materials() of render/visibility, and
// Texture::lookup() of core/scene.
#include "surface_point.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// Texels of all textures and levels; see Texture.
layout(std430, binding = 0) restrict readonly buffer Texels { uint texels[]; };
// Values of the corners of each triangle: texture coordinates, and from places that are not 0 on
// second ones and colors.
layout(std430, binding = 1) restrict readonly buffer MeshValues { float mesh_values[]; };
// After a vector per pixel, for each pixel those that shade_surfaces.glsl reads.
layout(std430, binding = 3) restrict writeonly buffer Behind { vec4 behind[]; };
// A MaterialRecord per surface, whose textures are places here: of the encoding, the wraps along u
// and v, the number of levels, whether it uses second texture coordinates, and for each level width,
// height and its first texel.
layout(std430, binding = 7) restrict readonly buffer Records { uint records[]; };

uniform ivec2 film;
uniform float pixel_angle;  // between neighbouring rays
uniform float pixel_width;  // between parallel ones [u]
uniform int second_texcoords_at;
uniform int colors_at;

const int texture_header = 5;  // words before the levels

float number(int place) { return uintBitsToFloat(records[place]); }
vec3 color(int place) { return vec3(number(place), number(place + 1), number(place + 2)); }

float srgb_to_linear(float x) {
  return x <= srgb_knee * srgb_slope ? x / srgb_slope
                                     : pow((x + srgb_offset) / srgb_gain, srgb_exponent);
}

vec4 decoded(uint texel, uint encoding) {
  if (encoding == texture_shared_exponent) {
    const uvec3 mantissas = uvec3(texel, texel >> 9, texel >> 18) & 511u;
    return vec4(ldexp(vec3(mantissas), ivec3(int(texel >> 27) - 24)), 1.0);
  }
  const vec4 v = unpackUnorm4x8(texel);
  if (encoding == texture_linear) return v;
  return vec4(srgb_to_linear(v.r), srgb_to_linear(v.g), srgb_to_linear(v.b), v.a);
}

float wrapped(float x, uint wrap) {
  if (wrap == wrap_repeat) return x - floor(x);
  if (wrap == wrap_clamp) return clamp(x, 0.0, 1.0);
  const float fraction = x - 2.0 * floor(0.5 * x);
  return fraction > 1.0 ? 2.0 - fraction : fraction;
}

int wrapped_index(int i, int size, uint wrap) {
  if (wrap == wrap_repeat) return i < 0 ? i + size : i >= size ? i - size : i;
  return clamp(i, 0, size - 1);
}

vec4 bilinear(int texture_, int level, vec2 position) {
  const int place = texture_ + texture_header + 3 * level;
  const ivec2 size = ivec2(records[place], records[place + 1]);
  const vec2 at = position * vec2(size) - 0.5;
  const ivec2 low = ivec2(floor(at));
  const vec2 f = at - vec2(low);
  vec4 sum = vec4(0.0);
  for (int c = 0; c < 4; ++c) {
    const ivec2 corner_ = ivec2(c & 1, c >> 1);
    const ivec2 i = ivec2(wrapped_index(low.x + corner_.x, size.x, records[texture_ + 1]),
                          wrapped_index(low.y + corner_.y, size.y, records[texture_ + 2]));
    const vec2 weights = mix(1.0 - f, f, vec2(corner_));
    const uint texel = texels[records[place + 2] + uint(i.y) * uint(size.x) + uint(i.x)];
    sum += weights.x * weights.y * decoded(texel, records[texture_]);
  }
  return sum;
}

vec4 lookup(int texture_, vec2 uv, float footprint) {
  const vec2 position = vec2(wrapped(uv.x, records[texture_ + 1]),
                             wrapped(1.0 - uv.y, records[texture_ + 2]));
  const int last = int(records[texture_ + 3]) - 1;
  const float size = footprint * sqrt(float(records[texture_ + texture_header]) *
                                      float(records[texture_ + texture_header + 1]));
  const float level = size > 1.0 ? min(log2(size), float(last)) : 0.0;
  const int below = int(level);
  const vec4 fine = bilinear(texture_, below, position);
  const float fraction = level - float(below);
  if (!(fraction > 0.0)) return fine;
  return mix(fine, bilinear(texture_, below + 1, position), fraction);
}

// TextureFrame of render/visibility.
struct TextureFrame {
  vec2 uv;
  vec3 along_u, along_v;
  float density;
};

vec2 texcoord(int first, int corner_) {
  const int place = first + 2 * corner_;
  return vec2(mesh_values[place], mesh_values[place + 1]);
}

// The frame by the set of texture coordinates whose first value is at a place.
TextureFrame texture_frame(PixelHit hit, int first) {
  const vec2 t0 = texcoord(first, 3 * hit.triangle);
  const vec2 t1 = texcoord(first, 3 * hit.triangle + 1) - t0;
  const vec2 t2 = texcoord(first, 3 * hit.triangle + 2) - t0;
  const vec3 p0 = corner_of(hit.triangle, 0);
  const vec3 p1 = corner_of(hit.triangle, 1) - p0;
  const vec3 p2 = corner_of(hit.triangle, 2) - p0;
  TextureFrame frame;
  frame.uv = t0 + hit.u * t1 + hit.v * t2;
  frame.along_u = vec3(0.0);
  frame.along_v = vec3(0.0);
  frame.density = 0.0;
  const float determinant = t1.x * t2.y - t1.y * t2.x;
  const float area = length(cross(p1, p2));
  if (determinant == 0.0 || !(area > 0.0)) return frame;
  const float sign_ = determinant > 0.0 ? 1.0 : -1.0;
  frame.along_u = sign_ * (t2.y * p1 - t1.y * p2);
  frame.along_v = sign_ * (t1.x * p2 - t2.x * p1);
  frame.density = sqrt(abs(determinant) / area);
  return frame;
}

vec3 to_world(TextureFrame frame, vec3 of_texture, vec3 n) {
  const vec3 in_plane = frame.along_u - dot(frame.along_u, n) * n;
  const float length_ = length(in_plane);
  if (!(length_ > 0.0)) return n;
  const vec3 tangent = in_plane / length_;
  const vec3 across = cross(n, tangent);
  const float handedness = dot(across, frame.along_v) < 0.0 ? -1.0 : 1.0;
  return normalize(of_texture.x * tangent + of_texture.y * handedness * across + of_texture.z * n);
}

vec3 mesh_color(int corner_) {
  const int place = colors_at + 3 * corner_;
  return vec3(mesh_values[place], mesh_values[place + 1], mesh_values[place + 2]);
}

vec3 mesh_color(PixelHit hit) {
  if (colors_at == 0) return vec3(1.0);
  const int first = 3 * hit.triangle;
  return (1.0 - hit.u - hit.v) * mesh_color(first) + hit.u * mesh_color(first + 1) +
         hit.v * mesh_color(first + 2);
}

// The texture of a record's member there, averaged over a square of a side in the world; white if it
// has none.
vec4 lookup(TextureFrame frames[2], int member, float width) {
  const int texture_ = int(records[member]);
  if (texture_ == 0) return vec4(1.0);
  const TextureFrame frame = frames[records[texture_ + 4]];
  return lookup(texture_, frame.uv, width * frame.density);
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, film))) return;
  const int index = pixel.y * film.x + pixel.x;
  const PixelHit hit = hits[index];
  if (hit.triangle < 0) return;
  const SurfacePoint point = point_of(hit, pixel);
  const int record = material_size * point.surface;
  const int result = film.x * film.y + ggx_vectors * index;
  behind[result] = vec4(0.0);
  if (records[record + material_is_metallic_roughness] == 0u) return;

  TextureFrame frames[2];
  frames[0] = texture_frame(hit, 0);
  frames[1] = second_texcoords_at == 0 ? frames[0] : texture_frame(hit, second_texcoords_at);
  const float cosine = max(dot(point.normal, -ray_direction(pixel)), min_grazing_cosine);
  const float width = (pixel_angle * hit.distance + pixel_width) / cosine;
  const vec3 base_color = mesh_color(hit) * color(record + material_base_color) *
                          lookup(frames, record + material_base_color_texture, width).rgb;
  const vec4 sample_ = lookup(frames, record + material_metallic_roughness_texture, width);
  const vec3 emitted = color(record + material_emissive) *
                       lookup(frames, record + material_emissive_texture, width).rgb;
  const float metallic = clamp(number(record + material_metallic) * sample_.b, 0.0, 1.0);
  const float roughness = clamp(number(record + material_roughness) * sample_.g, 0.0, 1.0);
  const vec3 f0 = mix(vec3(dielectric_f0), base_color, metallic);
  const vec3 diffuse = (1.0 - metallic) * base_color * (1.0 - f0);
  const float alpha = max(roughness * roughness, min_alpha);

  vec3 normal = point.normal;
  const int map = int(records[record + material_normal_texture]);
  if (map != 0 && dot(normal, normal) > 0.0) {
    const vec3 n = 2.0 * lookup(frames, record + material_normal_texture, width).rgb - 1.0;
    const float scale = number(record + material_normal_scale);
    const vec3 of_texture = normalize(vec3(scale * n.xy, max(n.z, min_normal_height)));
    const float side = point.on_back ? -1.0 : 1.0;
    normal = side * to_world(frames[records[map + 4]], of_texture, side * normal);
  }
  behind[result] = vec4(normal, alpha);
  behind[result + 1] = vec4(diffuse, f0.r);
  behind[result + 2] = vec4(emitted, f0.g);
  behind[result + 3] = vec4(f0.b, 0.0, 0.0, 0.0);
}
