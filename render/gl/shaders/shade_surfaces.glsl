// Surface shading: surface_radiance() and VertexLighting of render/shading. The including file
// defines whether any surface is `glossy` (not diffuse), and whether any is `metallic`.
#include "grid_corners.glsl"
#include "lights.glsl"
#include "spherical_harmonics.glsl"
#include "surface_point.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// RGB per pixel. Not an image: software renderers recompile for other image sizes. Then what
// materials.glsl has found.
layout(std430, binding = 3) buffer Behind { vec4 behind[]; };
// Incident light at grid nodes, R G B 0 per basis function; in place of the first 0, the bits of
// GridOcclusion::blocked(). Then vertex lighting of surfaces with radiance transfer: per vertex the
// outgoing radiance, and per basis function the light still to be reflected. Then average depths
// around surfaces, four per vector, and the tables of measured materials.
layout(std430, binding = 6) readonly buffer Arriving { vec4 incident_values[]; };
// A SurfaceRecord per surface. From the places named below on the elements of a quarter turn
// (TurnElement), the polynomials of point and distant ScatterTable, the environment's coefficients
// R G B 0 and the polynomials of its ScatterTable, and for each light the density of the medium
// there.
layout(std430, binding = 7) readonly buffer Values { float values[]; };

uniform float b0;
uniform float albedo;
uniform ivec2 film;
// 1: instead of tables, the optical depth of Gaussians per light and pixel.
uniform int has_depths;
uniform int scatters;  // whether the medium sends light of point lights around
uniform int scatter_at, environment_at, densities_at;
uniform int has_environment;
// See SurfaceLighting.
uniform float extinction;
uniform int incident_is_all;
uniform float incident_scale;
uniform float fog_depth;         // b0's part of the average depth
uniform int incident_levels;                 // 0: there is none
uniform vec4 incident_first[max_grid_levels];  // as source.glsl has them
uniform ivec4 incident_count[max_grid_levels];

uniform uint incident_occlusion_bits;        // SourceGrid::occlusion_bits() of the eye

uint corner_bits(int first) {
  return floatBitsToUint(incident_values[first].w) & incident_occlusion_bits;
}

vec3 values_rgb(int index) { return vec3(values[index], values[index + 1], values[index + 2]); }

// Incident light of a surface that is not diffuse, still to be reflected.
vec3 light[sh_count];

#include "radiance_map.glsl"
#include "measured_brdf.glsl"
#include "reflection.glsl"
#include "ggx.glsl"

// Of a metallic-roughness material.
Ggx ggx = Ggx(false, vec3(0.0), vec3(0.0), vec3(0.0), 1.0);

// A light as seen from a point.
struct LightAtPoint {
  vec3 w;  // from the light
  float length_;
  float cosine;
  float inverse_square;
  float depth;
};

LightAtPoint point_to_light(int l, SurfacePoint point, int pixel, int pixels) {
  LightAtPoint light_at_point;
  const vec3 q = point.position - lights[l].position;
  const float square = dot(q, q);
  const float inverse = square > tiny ? 1.0 / sqrt(square) : 0.0;
  light_at_point.w = inverse * q;
  light_at_point.length_ = square * inverse;
  light_at_point.cosine = -dot(light_at_point.w, point.normal);
  light_at_point.inverse_square =
      falloff_towards(l, light_at_point.w) /
      max(max(square, lights[l].radius2), tiny);
  light_at_point.depth =
      b0 * length_in_fog(l, point.position, light_at_point.w, light_at_point.length_);
  if (has_depths != 0) {
    light_at_point.depth += uintBitsToFloat(tables[l * pixels + pixel]);
  } else if (lights[l].has_table != 0) {
    light_at_point.depth +=
        table_depth(l, point.position - lights[l].map_origin.xyz, light_at_point.length_);
  }
  light_at_point.depth *= extinction;
  return light_at_point;
}

bool is_lit(int l, SurfacePoint point, float length_) {
  const float end = 1.0 - light_margin -
      float(position_rounding) * max_component(abs(lights[l].position)) / length_;
  // Parametrised so that the light is at t = 1.
  const vec3 to_light = lights[l].position - point.shadow_origin;
  return trace(point.shadow_origin, to_light, 0.0, end, true).triangle < 0;
}

vec3 direct_light(int l, SurfacePoint point, LightAtPoint light_at_point, vec3 to_eye) {
  if (!(light_at_point.cosine > 0.0) || !is_lit(l, point, light_at_point.length_)) return vec3(0.0);
  const int material = surface_size * point.surface;
  const vec3 intensity = lights[l].intensity;
  const float incoming =
      light_at_point.cosine * light_at_point.inverse_square * exp(-light_at_point.depth);
  if (metallic && ggx.is_set) {
    return ggx_brdf(ggx, -light_at_point.w, to_eye, point.normal) * intensity * incoming;
  }
  const int measured = int(values[material + surface_measured_at]);
  if (measured >= 0) {
    return measured_brdf(measured, -light_at_point.w, to_eye, point.normal) * intensity * incoming;
  }
  const vec3 radiance = incoming * (values_rgb(material + surface_diffuse) * intensity);
  const vec3 highlight = values_rgb(material + surface_highlight);
  // w mirrored at the normal, times the direction to the eye.
  const float r =
      2.0 * light_at_point.cosine * dot(point.normal, to_eye) + dot(light_at_point.w, to_eye);
  if (highlight == vec3(0.0) || !(r > 0.0)) return radiance;
  const float lobe = phong_lobe(r, values[material + surface_exponent]);
  return radiance + incoming * lobe * (highlight * intensity);
}

float scatter_polynomial(int first, float x) {
  float p = values[first];
  for (int i = 1; i < scatter_terms; ++i) p = p * x + values[first + i];
  return p;
}

// find_spread(): per band, the fraction of a point light scattered onto a point.
void find_spread(int l, LightAtPoint light_at_point, out float factors[sh_bands]) {
  for (int k = 0; k < sh_bands; ++k) factors[k] = 0.0;
  if (!(light_at_point.depth > 0.0 && light_at_point.depth < scatter_opaque)) return;
  const float homogeneous = values[densities_at + l] * light_at_point.length_;
  const float homogeneous_fraction =
      homogeneous < light_at_point.depth ? homogeneous / light_at_point.depth : 1.0;
  const float x = scatter_position(light_at_point.depth);
  const float once = light_at_point.depth * exp(-light_at_point.depth);
  for (int k = 0; k < sh_bands; ++k) {
    if (!glossy && (k == 3 || k == 5)) continue;  // nothing to a diffuse surface
    factors[k] = once * mix(scatter_polynomial(scatter_at + (sh_bands + k) * scatter_terms, x),
                            scatter_polynomial(scatter_at + k * scatter_terms, x),
                            homogeneous_fraction);
  }
}

// add_scattered_light(): its diffuse reflection.
vec3 scattered_light(int l, SurfacePoint point, LightAtPoint light_at_point, float factors[sh_bands]) {
  const float irradiance =
      band_irradiance(light_at_point.cosine, factors[0], factors[1], factors[2], factors[4]);
  return max(irradiance, 0.0) * light_at_point.inverse_square *
         (values_rgb(surface_size * point.surface + surface_diffuse) * lights[l].intensity * albedo);
}

// light += that, for surfaces that are not diffuse.
void add_scattered(int l, LightAtPoint light_at_point, float factors[sh_bands]) {
  float y[sh_count];
  sh_basis(-light_at_point.w, y);
  for (int k = 0; k < sh_bands; ++k) {
    const vec3 band = light_at_point.inverse_square * factors[k] * (lights[l].intensity * albedo);
    for (int i = k * k; i < (k + 1) * (k + 1); ++i) light[i] += y[i] * band;
  }
}

// Light from around a point: with a grid what that holds, else per band the fraction of the
// environment's.
vec3 incoming[grid_functions];
float fractions[sh_bands];

void find_incoming(SurfacePoint point, vec3 to_eye) {
  const vec3 p = point.position;
  int level = 0;
  vec3 coordinate = incident_first[0].w * (p - incident_first[0].xyz);
  while (level + 1 < incident_levels &&
         (any(lessThan(coordinate, vec3(0.0))) ||
          any(greaterThan(coordinate, vec3(incident_count[level].xyz - 1))))) {
    ++level;
    coordinate = incident_first[level].w * (p - incident_first[level].xyz);
  }
  if (incident_is_all != 0) {
    coordinate += 0.5 * dot(abs(point.normal), vec3(1.0)) * point.normal;
  }
  const ivec4 count = incident_count[level];
  const vec3 last = vec3(count.xyz - 2);
  const vec3 inside = clamp(coordinate, vec3(0.0), last + 1.0);
  const vec3 low = min(floor(inside), last);
  const vec3 f = inside - low;
  int firsts[8];
  float weights[8];
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 weight = mix(1.0 - f, f, vec3(corner_));
    const ivec3 node = ivec3(low) + corner_;
    weights[c] = weight.x * weight.y * weight.z;
    firsts[c] = count.w + ((node.z * count.y + node.y) * count.x + node.x) * grid_functions;
  }
  if (incident_is_all != 0) {
    hide_corners(eye_corner(to_eye), firsts, weights);
  }
  for (int i = 0; i < grid_functions; ++i) incoming[i] = vec3(0.0);
  for (int c = 0; c < 8; ++c) {
    for (int i = 0; i < grid_functions; ++i) {
      incoming[i] += weights[c] * incident_values[firsts[c] + i].rgb;
    }
  }
}

// AverageDepthGrid of render/lighting.
float average_depth(SurfacePoint point) {
  const int surface = surface_size * point.surface;
  const int first = int(values[surface + surface_average_depths_at]);
  if (first < 0) return 0.0;
  const ivec3 nodes_ = ivec3(values_rgb(surface + surface_grid_nodes));
  const vec3 coordinate = clamp((point.position - values_rgb(surface + surface_grid_corner)) *
                                    values_rgb(surface + surface_cells_per_unit),
                                vec3(0.0), vec3(nodes_ - 1));
  const ivec3 cell = min(ivec3(coordinate), max(nodes_ - 2, 0));
  const vec3 f = coordinate - vec3(cell);
  float sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 weights = mix(1.0 - f, f, vec3(corner_));
    const ivec3 node = min(cell + corner_, nodes_ - 1);
    const int i = (node.z * nodes_.y + node.y) * nodes_.x + node.x;
    sum += weights.x * weights.y * weights.z * incident_values[first + i / 4][i % 4];
  }
  return sum;
}

// EnvironmentLight::incident(): per-band fractions, without a grid.
void find_fractions(SurfacePoint point) {
  const float depth = fog_depth + average_depth(point);
  const float unscattered = exp(-depth);
  const float x = scatter_position(depth);
  const bool passes = depth > 0.0 && depth < scatter_opaque;
  const int first = environment_at + 4 * sh_count;
  for (int l = 0; l < sh_bands; ++l) {
    const float spread = scatter_polynomial(first + l * scatter_terms, x);
    fractions[l] = unscattered + (passes ? albedo * depth * unscattered * spread : 0.0);
  }
}

// Mean incident light relative to that of the environment without medium, at most 1.
vec3 dimming(vec3 mean) {
  if (has_environment == 0) return vec3(0.0);
  const vec3 all = values_rgb(environment_at);
  const vec3 fraction = min(incident_scale * mean / max(all, vec3(tiny_square)), vec3(1.0));
  return mix(vec3(0.0), fraction, greaterThan(all, vec3(0.0)));
}

void find_light_from_around(SurfacePoint point, vec3 to_eye) {
  if (incident_levels > 0) {
    find_incoming(point, to_eye);
  } else {
    find_fractions(point);
  }
}

// diffuse_light() of that, of a surface of reflectance 1.
vec3 light_from_around(SurfacePoint point) {
  float y[sh_count];
  sh_basis(point.normal, y);
  vec3 sum = vec3(0.0);
  if (incident_levels > 0) {
    for (int l = 0; l < 3; ++l) {
      vec3 band = vec3(0.0);
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) band += y[i] * incoming[i];
      sum += incident_scale * cosine_factors[l] * band;
    }
    if (has_environment == 0) return max(sum, vec3(0.0));
    vec3 fifth = vec3(0.0);
    for (int i = 16; i < 25; ++i) fifth += y[i] * values_rgb(environment_at + 4 * i);
    return max(sum + cosine_factors[4] * dimming(incoming[0]) * fifth, vec3(0.0));
  }
  for (int l = 0; l < sh_bands; ++l) {
    vec3 band = vec3(0.0);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      band += y[i] * values_rgb(environment_at + 4 * i);
    }
    sum += cosine_factors[l] * fractions[l] * band;
  }
  return max(sum, vec3(0.0));
}

// light += incident_light().
void add_light_from_around() {
  for (int l = 0; l < sh_bands; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      const vec3 outside =
          has_environment != 0 ? values_rgb(environment_at + 4 * i) : vec3(0.0);
      if (incident_levels == 0) {
        light[i] += fractions[l] * outside;
      } else if (i < grid_functions) {
        light[i] += incident_scale * incoming[i];
      } else {
        light[i] += dimming(incoming[0]) * outside;
      }
    }
  }
}

// VertexLighting::add(): what radiance transfer has made of light at the vertices. Adds to `light`
// what is still to be reflected; whether there is any.
vec3 transferred_light(SurfacePoint point, PixelHit hit, out bool is_unreflected) {
  is_unreflected = false;
  const int surface = surface_size * point.surface;
  const int first = int(values[surface + (point.on_back ? surface_back_at : surface_front_at)]);
  if (first < 0) return vec3(0.0);
  const float weights[3] = float[](1.0 - hit.u - hit.v, hit.u, hit.v);
  const int functions = int(values[surface + surface_transferred_functions]);
  is_unreflected = glossy && functions > 0;
  vec3 sent = vec3(0.0);
  for (int k = 0; k < 3; ++k) {
    const int index = first + (1 + functions) * vertex_of(hit.triangle, k);
    sent += weights[k] * incident_values[index].rgb;
    if (!is_unreflected) continue;
    for (int i = 0; i < functions; ++i) light[i] += weights[k] * incident_values[index + 1 + i].rgb;
  }
  return sent;
}

vec3 surface_light(SurfacePoint point, PixelHit hit, vec3 to_eye, int index, int pixels) {
  const int surface = surface_size * point.surface;
  const bool transferred = values[surface + surface_has_transfer] > 0.0;
  const bool is_ggx = metallic && ggx.is_set;
  const bool is_diffuse =
      !is_ggx && (!glossy || values[surface + surface_reflection_at] == 0.0);
  const bool is_scattered = scatters != 0 && !transferred;
  if (glossy) {
    for (int i = 0; i < sh_count; ++i) light[i] = vec3(0.0);
  }
  vec3 radiance = vec3(0.0);
  for (int l = 0; l < light_count; ++l) {
    const LightAtPoint light_at_point = point_to_light(l, point, index, pixels);
    radiance += direct_light(l, point, light_at_point, to_eye);
    if (!is_scattered) continue;
    float factors[sh_bands];
    find_spread(l, light_at_point, factors);
    if (is_diffuse) {
      radiance += scattered_light(l, point, light_at_point, factors);
    } else {
      add_scattered(l, light_at_point, factors);
    }
  }
  vec3 rest = vec3(0.0);
  bool is_unreflected = !is_diffuse;
  if (transferred) {
    rest = transferred_light(point, hit, is_unreflected);
  } else if (has_environment != 0 || incident_levels > 0) {
    find_light_from_around(point, to_eye);
    if (is_diffuse) {
      // values has reflectance / pi
      rest = pi * values_rgb(surface + surface_diffuse) * light_from_around(point);
    } else {
      add_light_from_around();
    }
  }
  // In one place: this is most of the shader.
  if (glossy && is_unreflected) {
    const float cosine = turn_to_eye(point.normal, to_eye);
    if (is_ggx) {
      rest += ggx_reflected(ggx, cosine);
    } else {
      rest += reflected(int(values[surface + surface_reflection_at]), cosine);
    }
  }
  radiance += max(rest, vec3(0.0));
  return is_ggx ? radiance + ggx.emitted : radiance;
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, film))) return;
  const int index = pixel.y * film.x + pixel.x;
  const PixelHit hit = hits[index];
  vec3 radiance = vec3(0.0);
  if (hit.triangle >= 0) {
    SurfacePoint point = point_of(hit, pixel);
    if (metallic) ggx = ggx_of(film.x * film.y + ggx_vectors * index, point.normal);
    radiance = surface_light(point, hit, -ray_direction(pixel), index, film.x * film.y);
  }
  behind[index] = vec4(radiance, 0.0);
}
