// Surface shading: surface_radiance() and VertexLighting of render/shading. The including file
// defines whether any surface is `glossy` (not diffuse), and whether any is `metallic`.
#include "grid_corners.glsl"
#include "lights.glsl"
#include "spherical_harmonics.glsl"
#include "surface_point.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// RGB per pixel. Not an image: software renderers recompile for other image sizes. Then what
// materials.glsl has found.
layout(std430, binding = 3) restrict buffer Behind { vec4 behind[]; };
// Incident light at grid nodes, R G B 0 per basis function; in place of the first 0, the bits of
// GridOcclusion::blocked(). Then vertex lighting of surfaces with radiance transfer: per vertex the
// outgoing radiance, and per basis function the light still to be reflected. Then average depths
// around surfaces, four per vector, and the tables of measured materials.
layout(std430, binding = 6) restrict readonly buffer Arriving { vec4 incident_values[]; };
// The lights that reach each pixel, as surface_shadows.glsl writes them.
layout(std430, binding = 4) restrict readonly buffer Lit { uint lit[]; };
// A SurfaceRecord per surface. From the places named below on the polynomials of point and distant
// ScatterTable, the environment's coefficients R G B 0 and the polynomials of its ScatterTable, and
// for each light the density of the medium there.
layout(std430, binding = 7) restrict readonly buffer Values { float values[]; };

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
uniform float fog_depth;         // b0's part of the average depth, where it is the same everywhere
uniform vec3 fog_center;         // else of a ball
uniform float fog_radius;
uniform int incident_levels;                 // 0: there is none
uniform vec4 incident_first[max_grid_levels];  // as source.glsl has them
uniform ivec4 incident_count[max_grid_levels];
uniform ivec4 incident_eye_layers[max_grid_levels];

uniform uint incident_occlusion_bits;        // NodeVisibility of the eye

uint corner_bits(int first) {
  return floatBitsToUint(incident_values[first].w) & incident_occlusion_bits;
}

vec3 values_rgb(int index) { return vec3(values[index], values[index + 1], values[index + 2]); }

float scatter_polynomial(int first, float x) {
  float p = values[first];
  for (int i = 1; i < scatter_terms; ++i) p = p * x + values[first + i];
  return p;
}

#include "radiance_map.glsl"
#include "light_around.glsl"
#include "measured_brdf.glsl"
#include "reflection.glsl"
#include "ggx.glsl"

// The reflection of a metallic-roughness material.
Ggx ggx = Ggx(false, vec3(0.0), vec3(0.0), vec3(0.0), 1.0);

vec3 reflectance(int i) {
  return metallic && ggx.is_set ? ggx_reflectance(ggx, i) : table_reflectance(i);
}

#include "sh_turns.glsl"

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
  float sent = falloff_towards(l, light_at_point.w);
  if (lights[l].area_points > 1) {
    sent = max(sent, least_of_area);
  } else if (lights[l].area_points == 1 && !(sent > least_of_area)) {
    sent = 0.0;
  }
  light_at_point.inverse_square = sent / max(max(square, lights[l].radius2), tiny);
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

// AreaOutline::corner(), relative to a point.
vec3 area_corner(int l, int k, vec3 position) {
  const float t = 2.0 * pi * (float(k) + 0.5) / float(lights[l].area_corners);
  return lights[l].area_center + cos(t) * lights[l].area_u + sin(t) * lights[l].area_v - position;
}

// area_irradiance() of the area light that a light is a point of.
float area_irradiance(int l, SurfacePoint point) {
  const bool is_two_sided = lights[l].area_is_two_sided != 0;
  if (lights[l].area_corners == 0) {
    const vec3 to_center = lights[l].area_center - point.position;
    const float radius = lights[l].area_radius;
    if (dot(to_center, to_center) <= radius * radius) return is_two_sided ? pi : 0.0;
    return sphere_irradiance(to_center, point.normal, radius);
  }
  PolygonLight polygon = no_polygon_light(0.0);
  vec3 corner = area_corner(l, 0, point.position);
  for (int k = 1; k <= lights[l].area_corners; ++k) {
    const vec3 next = area_corner(l, k, point.position);
    polygon = with_edge(polygon, corner, next, point.normal);
    corner = next;
  }
  const float sum = polygon_irradiance(polygon, point.normal);
  return is_two_sided ? abs(sum) : max(sum, 0.0);
}

vec3 direct_light(int l, SurfacePoint point, LightAtPoint light_at_point, vec3 to_eye, int pixel,
                  int pixels) {
  const uint bits = lit[l / light_bits * pixels + pixel];
  if ((bits >> (l % light_bits) & 1u) == 0u || !(light_at_point.cosine > 0.0)) return vec3(0.0);
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

// Its reflection by surfaces that are not diffuse: the light is symmetric about its direction, so
// that it need not be turned.
vec3 reflected_scattered_light(int l, LightAtPoint light_at_point, float factors[sh_bands],
                               SurfaceFrame frame) {
  const vec3 near_normal = turned_to_normal(frame, -light_at_point.w);
  const vec3 w = vec3(frame.eye.x * near_normal.x + frame.eye.y * near_normal.y,
                      frame.eye.x * near_normal.y - frame.eye.y * near_normal.x, near_normal.z);
  vec3 sum = vec3(0.0);
  vec2 turned = vec2(1.0, 0.0);  // sin^m(theta) times cos(m phi) and sin(m phi)
  float first = 0.5 * inv_sqrt_pi;
  for (int m = 0; m < sh_bands; ++m) {
    if (m > 0) {
      first *= sh_start[m];
      turned = turned_further(turned, w.xy);
    }
    float q = first;
    float below = 0.0;
    for (int k = m; k < sh_bands; ++k) {
      if (k > m) {
        const float next = sh_next(k, m, w.z, q, below);
        below = q;
        q = next;
      }
      sum += factors[k] * q * turned.x * reflectance(k * (k + 1) / 2 + m);
    }
  }
  return light_at_point.inverse_square * sum * (lights[l].intensity * albedo);
}

// VertexLighting::add(): what radiance transfer has made of light at the vertices. Finds the light
// that is still to be reflected; whether there is any.
vec3 transferred_light(SurfacePoint point, PixelHit hit, out bool is_unreflected) {
  is_unreflected = false;
  const int surface = surface_size * point.surface;
  const int first = int(values[surface + (point.on_back ? surface_back_at : surface_front_at)]);
  if (first < 0) return vec3(0.0);
  const vec3 weights = vec3(1.0 - hit.u - hit.v, hit.u, hit.v);
  const int functions = int(values[surface + surface_transferred_functions]);
  is_unreflected = glossy && functions > 0;
  ivec3 places;
  for (int k = 0; k < 3; ++k) {
    places[k] = first + (1 + functions) * vertex_of(hit.triangle, k);
  }
  find_light_of_vertices(places + 1, weights, functions);
  return weights.x * incident_values[places.x].rgb + weights.y * incident_values[places.y].rgb +
         weights.z * incident_values[places.z].rgb;
}

vec3 surface_light(SurfacePoint point, PixelHit hit, vec3 to_eye, int index, int pixels) {
  const int surface = surface_size * point.surface;
  const bool transferred = values[surface + surface_has_transfer] > 0.0;
  const bool is_ggx = metallic && ggx.is_set;
  const bool is_diffuse =
      !is_ggx && (!glossy || values[surface + surface_reflection_at] == 0.0);
  const bool is_scattered = scatters != 0 && !transferred;
  SurfaceFrame frame;
  if (!is_diffuse) {
    frame = frame_of(point.normal, to_eye);
    if (is_ggx) {
      find_ggx_rows(ggx, frame.eye_cosine);
    } else {
      reflection_table = row_at(int(values[surface + surface_reflection_at]), reflection_row,
                                reflection_intervals, frame.eye_cosine);
    }
  }
  vec3 radiance = vec3(0.0);
  vec3 rest = vec3(0.0);
  int area_points = 0;  // AreaSum: those to come, and what those before sent
  vec3 of_area = vec3(0.0);
  float area_sum = 0.0;
  for (int l = 0; l < light_count; ++l) {
    const LightAtPoint light_at_point = point_to_light(l, point, index, pixels);
    const vec3 direct = direct_light(l, point, light_at_point, to_eye, index, pixels);
    if (lights[l].area_points == 0) {
      radiance += direct;
    } else {
      if (area_points == 0) {
        area_points = lights[l].area_points;
        of_area = vec3(0.0);
        area_sum = 0.0;
      }
      of_area += direct;
      area_sum += max(light_at_point.cosine, 0.0) * light_at_point.inverse_square *
                  lights[l].area_of_point;
      --area_points;
      if (area_points == 0 && area_sum > tiny) {
        const vec3 to_center = lights[l].area_center - point.position;
        const bool is_far = dot(to_center, to_center) > lights[l].area_far2;
        radiance += is_far ? of_area : area_irradiance(l, point) / area_sum * of_area;
      }
    }
    if (!is_scattered) continue;
    float factors[sh_bands];
    find_spread(l, light_at_point, factors);
    if (is_diffuse) {
      radiance += scattered_light(l, point, light_at_point, factors);
    } else {
      rest += reflected_scattered_light(l, light_at_point, factors, frame);
    }
  }
  bool is_unreflected = !is_diffuse;
  if (transferred) {
    rest = transferred_light(point, hit, is_unreflected);
  } else if (has_environment != 0 || incident_levels > 0) {
    find_light_around(point, to_eye);
    if (is_diffuse) {
      // values has reflectance / pi
      rest = pi * values_rgb(surface + surface_diffuse) * diffuse_light(point.normal);
    }
  } else {
    is_unreflected = false;
  }
  if (glossy && is_unreflected) rest += reflected_light(frame);
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
