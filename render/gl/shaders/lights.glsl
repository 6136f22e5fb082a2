// Light from point lights at points on a view ray: see sum_slices() in render/lighting/slice_kernels.h.
#include "direction_map.glsl"
#include "gaussian.glsl"

layout(std430, binding = 0) readonly buffer Lights { Light lights[]; };
layout(std430, binding = 1) readonly buffer Tables { uint tables[]; };

uniform int light_count;

// The depth of a light's table at a point relative to it, `distance_` from it.
float table_depth(int l, vec3 q, float distance_) {
  const MapPosition position = map_position(lights[l].table, q, distance_);
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
