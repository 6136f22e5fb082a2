// The light that surfaces send to the eye: surface_radiance() of render/cpu, for diffuse materials,
// and of lamps alone for those by Phong.
#include "lights.glsl"
#include "rays.glsl"
#include "spherical_harmonics.glsl"
#include "surface_point.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// RGB per pixel. Not an image: software compiles a shader anew for other sizes of images.
layout(std430, binding = 3) writeonly buffer Behind { vec4 behind[]; };
// What arrives of an environment at the nodes of a grid: for each basis function R G B 0.
layout(std430, binding = 6) readonly buffer Arriving { vec4 arriving_values[]; };
// Per surface its reflectance / pi, Phong's exponent and highlight, and a gap; from the places
// named below on the polynomials of point and distant ScatterTable, the environment's coefficients
// R G B 0, and for each light the density of the medium there.
layout(std430, binding = 7) readonly buffer Values { float values[]; };

uniform float b0;
uniform float albedo;
uniform float margin;  // Visibility::self_hit_margin
uniform ivec2 film;
// 1: instead of tables there are, of each light and pixel, what Gaussians take of the light.
uniform int has_depths;
uniform int scatters;  // whether the medium sends light of lamps around
uniform int scatter_at, environment_at, densities_at;
uniform int has_environment;
uniform float environment_intensity;
uniform float environment_shares[sh_bands];  // of what arrives, where there is no grid
uniform int arriving_levels;                 // 0: there is none
uniform vec4 arriving_first[2];              // as source.glsl has them
uniform ivec4 arriving_count[2];

vec3 values_rgb(int at) { return vec3(values[at], values[at + 1], values[at + 2]); }

// A light as seen from a point.
struct LightAtPoint {
  vec3 w;  // from the light
  float length_;
  float cosine;
  float inverse_square;
  float depth;
};

LightAtPoint see_light(int l, SurfacePoint point, int pixel, int pixels) {
  LightAtPoint at;
  const vec3 q = point.position - lights[l].position.xyz;
  const float square = dot(q, q);
  const float inverse = square > 1e-30 ? 1.0 / sqrt(square) : 0.0;
  at.w = inverse * q;
  at.length_ = square * inverse;
  at.cosine = -dot(at.w, point.normal);
  at.inverse_square = inverse * inverse;
  at.depth = b0 * at.length_;
  if (has_depths != 0) {
    at.depth += uintBitsToFloat(tables[l * pixels + pixel]);
  } else if (lights[l].has.x != 0) {
    at.depth += table_depth(l, q, at.length_);
  }
  return at;
}

bool is_lit(int l, SurfacePoint point, float length_) {
  const float away = min(margin, margin * 2.0 * float(surfaces_radius) / length_);
  // The whole way is 1.
  const vec3 way = lights[l].position.xyz - point.shadow_origin;
  return trace(point.shadow_origin, way, away, 1.0 - away, true).triangle < 0;
}

vec3 direct_light(int l, SurfacePoint point, LightAtPoint at, vec3 to_eye) {
  if (!(at.cosine > 0.0) || !is_lit(l, point, at.length_)) return vec3(0.0);
  const int material = 8 * point.surface;
  const vec3 intensity = lights[l].intensity.rgb;
  const float arrives = at.cosine * at.inverse_square * exp(-at.depth);
  vec3 radiance = arrives * (values_rgb(material) * intensity);
  const vec3 highlight = values_rgb(material + 4);
  // w mirrored at the normal, times the direction to the eye.
  const float r = 2.0 * at.cosine * dot(point.normal, to_eye) + dot(at.w, to_eye);
  if (highlight == vec3(0.0) || !(r > 0.0)) return radiance;
  const float lobe = exp(values[material + 3] * log(clamp(r, 1e-30, 1.0)));
  return radiance + arrives * lobe * (highlight * intensity);
}

float scatter_polynomial(int at, float x) {
  float p = values[at];
  for (int i = 1; i < scatter_terms; ++i) p = p * x + values[at + i];
  return p;
}

// find_spread() and add_scattered_light(): what the medium scatters of a lamp onto the point, which
// no surface shadows.
vec3 scattered_light(int l, SurfacePoint point, LightAtPoint at) {
  if (!(at.depth > 0.0 && at.depth < scatter_opaque)) return vec3(0.0);
  const float homogeneous = values[densities_at + l] * at.length_;
  const float share = homogeneous < at.depth ? homogeneous / at.depth : 1.0;
  const float root = sqrt(at.depth);
  const float x = scatter_scale * root / (root + 1.0) - 1.0;
  float factors[5];
  for (int k = 0; k < 5; ++k) {
    if (k == 3) continue;
    factors[k] = mix(scatter_polynomial(scatter_at + (sh_bands + k) * scatter_terms, x),
                     scatter_polynomial(scatter_at + k * scatter_terms, x), share);
  }
  const float c = at.cosine;
  const float c2 = c * c;
  const float irradiance = 0.25 * factors[0] + 0.5 * c * factors[1] +
                           0.3125 * (1.5 * c2 - 0.5) * factors[2] -
                           0.09375 * ((4.375 * c2 - 3.75) * c2 + 0.375) * factors[4];
  return max(at.depth * exp(-at.depth) * irradiance, 0.0) * at.inverse_square *
         (values_rgb(8 * point.surface) * lights[l].intensity.rgb * albedo);
}

// What arrives at a point, by the grid.
void find_arriving(vec3 p, out vec3 light[grid_functions]) {
  int level = 0;
  vec3 at = arriving_first[0].w * (p - arriving_first[0].xyz);
  if (arriving_levels > 1 && (any(lessThan(at, vec3(0.0))) ||
                              any(greaterThan(at, vec3(arriving_count[0].xyz - 1))))) {
    level = 1;
    at = arriving_first[1].w * (p - arriving_first[1].xyz);
  }
  const ivec4 count = arriving_count[level];
  const vec3 last = vec3(count.xyz - 2);
  const vec3 inside = clamp(at, vec3(0.0), last + 1.0);
  const vec3 low = min(floor(inside), last);
  const vec3 f = inside - low;
  for (int i = 0; i < grid_functions; ++i) light[i] = vec3(0.0);
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 share = mix(1.0 - f, f, vec3(corner_));
    const ivec3 node = ivec3(low) + corner_;
    const int first =
        count.w + ((node.z * count.y + node.y) * count.x + node.x) * grid_functions;
    for (int i = 0; i < grid_functions; ++i) {
      light[i] += share.x * share.y * share.z * arriving_values[first + i].rgb;
    }
  }
}

// EnvironmentLight::diffuse() of a surface of reflectance 1.
vec3 environment_light(SurfacePoint point) {
  float y[sh_count];
  sh_basis(point.normal, y);
  vec3 sum = vec3(0.0);
  if (arriving_levels > 0) {
    vec3 light[grid_functions];
    find_arriving(point.position, light);
    for (int l = 0; l < 3; ++l) {
      vec3 band = vec3(0.0);
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) band += y[i] * light[i];
      sum += environment_intensity * cosine_factors[l] * band;
    }
    vec3 fifth = vec3(0.0);
    for (int i = 16; i < 25; ++i) fifth += y[i] * values_rgb(environment_at + 4 * i);
    const vec3 all = values_rgb(environment_at);
    const vec3 left = environment_intensity * light[0];
    const vec3 dimming = mix(vec3(0.0), left / max(all, vec3(1e-37)), greaterThan(all, vec3(0.0)));
    return max(sum + cosine_factors[4] * dimming * fifth, vec3(0.0));
  }
  for (int l = 0; l < sh_bands; ++l) {
    vec3 band = vec3(0.0);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      band += y[i] * values_rgb(environment_at + 4 * i);
    }
    sum += cosine_factors[l] * environment_shares[l] * band;
  }
  return max(sum, vec3(0.0));
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, film))) return;
  const int index = pixel.y * film.x + pixel.x;
  const ivec4 hit = hits[index];
  vec3 radiance = vec3(0.0);
  if (hit.w >= 0) {
    const vec3 to_eye = -ray_direction(pixel);
    const SurfacePoint point = point_of(hit, to_eye, margin * float(surfaces_radius));
    for (int l = 0; l < light_count; ++l) {
      const LightAtPoint at = see_light(l, point, index, film.x * film.y);
      radiance += direct_light(l, point, at, to_eye);
      if (scatters != 0) radiance += scattered_light(l, point, at);
    }
    if (has_environment != 0) {
      // values has reflectance / pi.
      radiance += 3.14159265358979 * values_rgb(8 * point.surface) * environment_light(point);
    }
  }
  behind[index] = vec4(radiance, 0.0);
}
