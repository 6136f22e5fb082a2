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

// The mean of 1 / r^2 over t in [ts + a, ts + b] for a light at distance sqrt(h2) from the ray.
float mean_inverse_square(float a, float b, float h2) {
  const float dots = a * b + h2;
  const float crosses = sqrt(h2) * (b - a);
  const float ratio = crosses / dots;
  if (dots > 0.0 && ratio < atan_small_end) {
    const float y = ratio * ratio;
    float p = atan_small_coefficients[0];
    for (int i = 1; i < atan_small_coefficients.length(); ++i) {
      p = p * y + atan_small_coefficients[i];
    }
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

// SpotFalloff::at(), of a cosine.
float spot_falloff(int l, float cosine) {
  if (lights[l].spot_per_cosine == 0.0) return 1.0;
  const float share =
      clamp((cosine - lights[l].spot_dark_cosine) * lights[l].spot_per_cosine, 0.0, 1.0);
  return share * share;
}

// SpotMean of render/lighting/slice_falloff-inl.h: the mean of the falloff over r^2 over [a, b] from
// the point nearest to the light, and the middle of what is lit. `offset`: from there to the light.
vec2 spot_mean(int l, vec3 w, vec3 offset, float a, float b, float h2) {
  const float along = dot(w, lights[l].spot_axis);
  const float across = dot(offset, lights[l].spot_axis);
  float ends[6] = float[](a, b, b, b, b, b);
  for (int edge = 0; edge < 2; ++edge) {
    const float cosine =
        lights[l].spot_dark_cosine + (edge == 0 ? 0.0 : 1.0 / lights[l].spot_per_cosine);
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
  float sum = 0.0;
  float moment = 0.0;
  for (int i = 0; i < 5; ++i) {
    const float width = ends[i + 1] - ends[i];
    if (!(width > 0.0)) continue;
    const float middle = 0.5 * (ends[i] + ends[i + 1]);
    float falloff = 0.0;
    float whole = 0.0;
    for (int k = -1; k <= 1; ++k) {
      const float s = middle + 0.5 * width * gauss_3_place * float(k);
      const float r2 = s * s + h2;
      const float weight = (k == 0 ? gauss_3_middle : gauss_3_end) / r2;
      falloff += weight * spot_falloff(l, (s * along - across) * inversesqrt(r2));
      whole += weight;
    }
    const float arriving =
        mean_inverse_square(ends[i], ends[i + 1], h2) * width * falloff / whole;
    sum += arriving;
    moment += arriving * middle;
  }
  return sum > 0.0 ? vec2(sum / (b - a), moment / sum) : vec2(0.0, 0.5 * (a + b));
}
