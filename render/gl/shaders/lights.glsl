// Light from point lights at points on a view ray: see sum_slices() in render/slices/slice_kernels.h.
#include "direction_map.glsl"
#include "formulas.glsl"

layout(std430, binding = 0) restrict readonly buffer Lights { Light lights[]; };
layout(std430, binding = 1) restrict readonly buffer Tables { uint tables[]; };

// Photometric profiles and pictures: see IntensityMap.
layout(r32f, binding = 5) readonly uniform image2D profiles;

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

// CONES is defined where lights of the medium have cones or photometric profiles, ANISOTROPIC where
// the medium is: a software device (llvmpipe) ends all loops of a shader after 65535 rounds, and
// goes through those of a branch not taken once.

// PointSource::fog_length() from a point `distance_` from the light; `from_light`: unit.
float length_in_fog(int l, vec3 point, vec3 from_light, float distance_) {
  if (lights[l].fog_radius == 0.0) return distance_;
  const vec3 p = point - lights[l].fog_center;
  return fog_length(p, -dot(p, from_light), distance_, lights[l].fog_radius);
}

// The map of a profile or a picture in the direction of these components, see in_profile().
float map_at(int l, vec3 w) {
  const float last = float(lights[l].map_side - 1);
  const vec2 position = lights[l].cotangent > 0.0 ? cone_position(w, lights[l].cotangent)
                                                  : octahedral_position(w);
  const vec2 at = clamp(0.5 * last * (position + 1.0), 0.0, last);
  const ivec2 low = min(ivec2(at), lights[l].map_side - 2);
  const vec2 f = at - vec2(low);
  const ivec2 first = ivec2(lights[l].map_column, lights[l].map_row) + low;
  const float a = imageLoad(profiles, first).r;
  const float b = imageLoad(profiles, first + ivec2(1, 0)).r;
  const float c = imageLoad(profiles, first + ivec2(0, 1)).r;
  const float d = imageLoad(profiles, first + ivec2(1, 1)).r;
  return mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
}

// Components of a vector along the azimuths 0 and 90 of a cone, and along the axis of a falloff.
vec3 in_profile(int l, vec3 q) {
  return vec3(dot(q, lights[l].azimuth_0), dot(q, lights[l].azimuth_90),
              dot(q, lights[l].falloff_axis));
}

// LightFalloff::at() in the unit direction of these components, see in_profile().
float falloff_at(int l, vec3 w) {
  const int shape = lights[l].falloff_shape;
  if (shape == falloff_isotropic) return 1.0;
  if (shape == falloff_cosine) return clamp(w.z, 0.0, 1.0);
  if (shape == falloff_two_cosines) return min(abs(w.z), 1.0);
  const float in_cone = cone_falloff(w, lights[l].dark_versine, lights[l].per_versine);
  return lights[l].map_side > 0 ? in_cone * map_at(l, w) : in_cone;
}

// LightFalloff::at() in the unit direction w.
float falloff_towards(int l, vec3 w) {
  return falloff_at(l, in_profile(l, w));
}

// Falloff over r^2 and 1 / r^2 at s, weighted. `along` and `across`: the ray's direction and its
// offset as in_profile() has them.
vec2 falloff_sample(int l, vec3 along, vec3 across, float h2, float s, float weight) {
  const float r2 = s * s + h2;
  const float inverse = weight / r2;
  return vec2(inverse * falloff_at(l, (s * along - across) * inversesqrt(r2)), inverse);
}

// AnglesOfPart of render/slices/slice_falloff-inl.h: Gauss' rule over the angle that [begin, end]
// spans at a light that is h away from the ray.
struct AnglesOfPart {
  float first;
  float step_;  // of a panel
  int panels;
};

AnglesOfPart angles_of_part(float begin, float end, float h, float panel) {
  const float first = atan(begin / h);
  const float angle = max(atan(end / h) - first, 0.0);
  const int panels = 1 + int(angle / panel);
  return AnglesOfPart(first, angle / float(panels), panels);
}

// The angle of node k, 0 to 2, of panel i.
float angle_of_node(AnglesOfPart part, int i, int k) {
  return part.first + part.step_ * (float(i) + 0.5 + 0.5 * gauss_3_place * float(k - 1));
}

float weight_of_node(AnglesOfPart part, int k) {
  return part.step_ * (k == 1 ? gauss_3_middle : gauss_3_end);
}

// FalloffRays::AtAngle(), for an angle of this sine and cosine.
float falloff_at_angle(int l, vec3 along, vec3 across, float sine, float cosine, float h) {
  return falloff_at(l, sine * along - cosine / h * across);
}

bool has_cone(int l) {
  return lights[l].falloff_shape == falloff_cone || lights[l].map_side > 0;
}

float smooth_panel(int l) {
  if (lights[l].cotangent > 0.0) return picture_panel / lights[l].cotangent;
  return lights[l].map_side > 0 ? profile_panel : falloff_panel;
}

// The light that arrives between begin and end, where the falloff is smooth, and that times their
// middle.
vec2 falloff_part(int l, vec3 along, vec3 across, float h2, float begin, float end, bool is_wide) {
  const float width = end - begin;
  if (!(width > 0.0)) return vec2(0.0);
  const float middle = 0.5 * (begin + end);
  const float place = 0.5 * width * gauss_3_place;
  const vec2 sum = falloff_sample(l, along, across, h2, middle - place, gauss_3_end) +
                   falloff_sample(l, along, across, h2, middle, gauss_3_middle) +
                   falloff_sample(l, along, across, h2, middle + place, gauss_3_end);
  float arriving = mean_inverse_square(begin, end, h2) * width * sum.x / sum.y;
  if (is_wide && !has_cone(l)) {
    arriving = cosine_integral(along.z, across.z, h2, end) -
               cosine_integral(along.z, across.z, h2, begin);
    const bool is_two_sided = lights[l].falloff_shape == falloff_two_cosines;
    arriving = is_two_sided ? abs(arriving) : max(arriving, 0.0);
  }
  return vec2(arriving, arriving * middle);
}

// The same as falloff_part() for a part that spans a wide angle.
vec2 falloff_over_angle(int l, vec3 along, vec3 across, float h2, float begin, float end) {
  const float h = sqrt(h2);
  const AnglesOfPart part = angles_of_part(begin, end, h, smooth_panel(l));
  vec2 sum = vec2(0.0);
  for (int i = 0; i < part.panels; ++i) {
    for (int k = 0; k < 3; ++k) {
      const float theta = angle_of_node(part, i, k);
      const float sine = sin(theta);
      const float cosine = max(cos(theta), tiny);
      const float arriving =
          weight_of_node(part, k) * falloff_at_angle(l, along, across, sine, cosine, h);
      sum += arriving * vec2(1.0 / h, sine / cosine);
    }
  }
  return sum;
}

// The ends of the parts of [a, b] on which a falloff is smooth, ascending: between the dark and the
// full edges of a cone, and beside the plane of a cosine.
float[6] smooth_parts(int l, vec3 along, vec3 across, float h2, float a, float b) {
  float ends[6] = float[](a, b, b, b, b, b);
  if (lights[l].falloff_shape == falloff_isotropic) return ends;
  if (!has_cone(l)) {
    if (along.z != 0.0) ends[1] = clamp(across.z / along.z, a, b);
    return ends;
  }
#ifdef CONES
  for (int edge = 0; edge < 2; ++edge) {
    const float versine = lights[l].dark_versine - (edge == 0 ? 0.0 : 1.0 / lights[l].per_versine);
    const vec2 crossings = clamp(cone_edges(along, across, h2, versine, endless), a, b);
    ends[1 + 2 * edge] = crossings.x;
    ends[2 + 2 * edge] = crossings.y;
  }
  for (int i = 1; i < 4; ++i) {
    for (int k = 1; k < 5 - i; ++k) {
      const float low = min(ends[k], ends[k + 1]);
      ends[k + 1] = max(ends[k], ends[k + 1]);
      ends[k] = low;
    }
  }
#endif
  return ends;
}

// FalloffMean of render/slices/slice_falloff-inl.h: the mean of the falloff over r^2 over [a, b]
// from the point nearest to the light, and the middle of what is lit. `along` and `across`: the
// ray's direction and the offset from there to the light, as in_profile() has them; `angle`: that
// [a, b] spans at the light.
vec2 falloff_mean(int l, vec3 along, vec3 across, float a, float b, float h2, float angle) {
  const float[6] ends = smooth_parts(l, along, across, h2, a, b);
  const bool is_wide = angle > wide_falloff * smooth_panel(l);
  vec2 sum = falloff_part(l, along, across, h2, ends[0], ends[1], is_wide) +
             falloff_part(l, along, across, h2, ends[1], ends[2], is_wide);
#ifdef CONES
  if (has_cone(l)) {
    if (is_wide) {
      sum = vec2(0.0);
      for (int i = 0; i < 5; ++i) {
        sum += falloff_over_angle(l, along, across, h2, ends[i], ends[i + 1]);
      }
    } else {
      sum += falloff_part(l, along, across, h2, ends[2], ends[3], false) +
             falloff_part(l, along, across, h2, ends[3], ends[4], false) +
             falloff_part(l, along, across, h2, ends[4], ends[5], false);
    }
  }
#endif
  return sum.x > 0.0 ? vec2(sum.x / (b - a), clamp(sum.y / sum.x, a, b))
                     : vec2(0.0, 0.5 * (a + b));
}
