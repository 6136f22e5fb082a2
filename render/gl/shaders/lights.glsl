// Light from point lights at points on a view ray: see sum_slices() in render/lighting/slice_kernels.h.
#include "direction_map.glsl"
#include "gaussian.glsl"

layout(std430, binding = 0) readonly buffer Lights { Light lights[]; };
layout(std430, binding = 1) readonly buffer Tables { uint tables[]; };

uniform int light_count;

// The depth of a light's table at a point relative to its map_origin, `distance_` from the light.
float table_depth(int l, vec3 q, float distance_) {
  const MapPosition position = map_position(lights[l].table, q, lights[l].in_table.xyz, distance_);
  const int size = lights[l].radii;
  const float distance_past_first = max(distance_ - lights[l].first_radius, 0.0);
  const float r = min(distance_past_first * lights[l].radii_per_unit /
                          (1.0 + lights[l].curvature * distance_past_first),
                      float(size) - table_end);
  const int low = int(r);
  const float f = r - float(low);
  const int row = map_stride(lights[l].table) * size;
  const int first = lights[l].table.cells.z + position.cell * size + low;
  const vec2 a = unpackUnorm2x16(tables[first]);
  const vec2 b = unpackUnorm2x16(tables[first + size]);
  const vec2 c = unpackUnorm2x16(tables[first + row]);
  const vec2 d = unpackUnorm2x16(tables[first + row + size]);
  const vec2 both = mix(mix(a, b, position.f.x), mix(c, d, position.f.x), position.f.y);
  return lights[l].max_depth * mix(both.x, both.y, f);
}

// No loops below where one per slice and light can be avoided: a software device (llvmpipe) ends
// all loops of a shader after 65535 rounds.

// The mean of 1 / r^2 over t in [ts + a, ts + b] for a light at distance sqrt(h2) from the ray.
float mean_inverse_square(float a, float b, float h2) {
  const float dots = a * b + h2;
  const float crosses = sqrt(h2) * (b - a);
  const float ratio = crosses / dots;
  if (dots > 0.0 && ratio < atan_small_end) {
    const float y = ratio * ratio;
    const float[6] c = atan_small_coefficients;
    const float p = ((((c[0] * y + c[1]) * y + c[2]) * y + c[3]) * y + c[4]) * y + c[5];
    return p / max(dots, tiny);
  }
  return atan(crosses, dots) / max(crosses, tiny);
}

// PointSource::fog_length() from a point `distance_` from the light; `from_light`: unit.
float fog_length(int l, vec3 point, vec3 from_light, float distance_) {
  if (lights[l].fog_radius == 0.0) return distance_;
  const vec3 p = point - lights[l].fog_center;
  const float along = -dot(p, from_light);
  const float square = along * along + lights[l].fog_radius * lights[l].fog_radius - dot(p, p);
  const float half_chord = sqrt(max(square, 0.0));
  return clamp(half_chord - along, 0.0, 2.0 * half_chord);
}

// LightFalloff::at(), of a cosine.
float falloff_at(int l, float cosine) {
  const int shape = lights[l].falloff_shape;
  if (shape == falloff_isotropic) return 1.0;
  if (shape == falloff_cosine) return clamp(cosine, 0.0, 1.0);
  if (shape == falloff_two_cosines) return min(abs(cosine), 1.0);
  const float share = clamp((cosine - lights[l].dark_cosine) * lights[l].per_cosine, 0.0, 1.0);
  return share * share;
}

// Falloff over r^2 and 1 / r^2 at s, weighted.
vec2 falloff_sample(int l, float along, float across, float h2, float s, float weight) {
  const float r2 = s * s + h2;
  const float inverse = weight / r2;
  return vec2(inverse * falloff_at(l, (s * along - across) * inversesqrt(r2)), inverse);
}

// What arrives between begin and end, where the falloff is smooth, and that times their middle.
vec2 falloff_part(int l, float along, float across, float h2, float begin, float end) {
  const float width = end - begin;
  if (!(width > 0.0)) return vec2(0.0);
  const float middle = 0.5 * (begin + end);
  const float place = 0.5 * width * gauss_3_place;
  const vec2 sum = falloff_sample(l, along, across, h2, middle - place, gauss_3_end) +
                   falloff_sample(l, along, across, h2, middle, gauss_3_middle) +
                   falloff_sample(l, along, across, h2, middle + place, gauss_3_end);
  const float arriving = mean_inverse_square(begin, end, h2) * width * sum.x / sum.y;
  return vec2(arriving, arriving * middle);
}

// The parts of a cone: between its dark and its full edges.
vec2 cone_parts(int l, float along, float across, float h2, float a, float b) {
  float ends[6] = float[](a, b, b, b, b, b);
  for (int edge = 0; edge < 2; ++edge) {
    const float cosine = lights[l].dark_cosine + (edge == 0 ? 0.0 : 1.0 / lights[l].per_cosine);
    const float p = along * along - cosine * cosine;
    const float q = -along * across;
    const float r = across * across - cosine * cosine * h2;
    const float square = q * q - p * r;
    if (!(square >= 0.0)) continue;
    const float sum = -(q + (q < 0.0 ? -sqrt(square) : sqrt(square)));
    if (p != 0.0) ends[1 + 2 * edge] = clamp(sum / p, a, b);
    if (sum != 0.0) ends[2 + 2 * edge] = clamp(r / sum, a, b);
  }
  for (int i = 1; i < 4; ++i) {
    for (int k = 1; k < 5 - i; ++k) {
      const float low = min(ends[k], ends[k + 1]);
      ends[k + 1] = max(ends[k], ends[k + 1]);
      ends[k] = low;
    }
  }
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 5; ++i) sum += falloff_part(l, along, across, h2, ends[i], ends[i + 1]);
  return sum;
}

// FalloffMean of render/lighting/slice_falloff-inl.h: the mean of the falloff over r^2 over [a, b]
// from the point nearest to the light, and the middle of what is lit. `offset`: from there to the
// light.
vec2 falloff_mean(int l, vec3 w, vec3 offset, float a, float b, float h2) {
  const float along = dot(w, lights[l].falloff_axis);
  const float across = dot(offset, lights[l].falloff_axis);
  vec2 sum;
  if (lights[l].falloff_shape == falloff_cone) {
    sum = cone_parts(l, along, across, h2, a, b);
  } else {
    const float plane = along != 0.0 ? clamp(across / along, a, b) : b;
    sum = falloff_part(l, along, across, h2, a, plane) +
          falloff_part(l, along, across, h2, plane, b);
  }
  return sum.x > 0.0 ? vec2(sum.x / (b - a), sum.y / sum.x) : vec2(0.0, 0.5 * (a + b));
}
