// The paper's airlight: paper_airlight() and its kernels in render/cpu. One work group per tile, or
// per batch of exact pixels.
#include "constants.glsl"
#include "tile_list.glsl"

layout(std430, binding = 0) readonly buffer Lights { PaperLight lights[]; };
// Per light and Gaussian the optical depth from light to Gaussian to eye; then per Gaussian that to
// the eye.
layout(std430, binding = 1) readonly buffer Frozen { float frozen[]; };

#include "film.glsl"
#include "noise.glsl"
#include "environment_inscattering.glsl"

uniform int light_count;
uniform int gaussian_count;
uniform float b0;
uniform float anisotropy;
uniform int at_mean;
uniform int conserves;  // whether any light conserves energy

shared SeenGaussian batch[group_size];
shared uint batch_index[group_size];
#ifdef ELLIPSOIDS
shared EllipsoidWarp batch_ellipsoids[group_size];
#endif

// Optical depth of a Gaussian up to the projection of its center on the ray, clamped to the ray.
float depth_to_projection(LineProfile line, float scale_, float length_, float depth) {
  if (line.t0 <= 0.0) return 0.0;
  if (line.t0 >= length_) return depth;
  const float u = line.a * line.t0;
  const float unscaled_depth = u < 1.0 ? exp(-line.e) * erf_small(u)
                                       : exp(-line.e) - scaled_erfc(line.e, u);
  return scale_ * max(unscaled_depth, 0.0);
}

// The mean parameter of a Gaussian on [0, length_], in that interval: LineProfile::Mean().
float mean_parameter(LineProfile line, float length_, float view_unit_depth) {
  const float a = line.a;
  const float u0 = clamp(-a * line.t0, -erfc_end, erfc_end);
  const float u1 = clamp(a * (length_ - line.t0), -erfc_end, erfc_end);
  const float k = a * length_;
  const float max_t = max(line.t0, 0.0) + 1.0 / a;
  float t;
  if (k * (1.0 + abs(u0) + abs(u1)) < 1.0) {
    // The quotient cancels on a short segment: from its middle, by the density's slope there.
    const float m = 0.5 * (u0 + u1);
    const float second_order = k * k * (1.0 + m * m);
    t = 0.5 * length_ - m * k * length_ * (mean_shift[0] - second_order * mean_shift[1]);
  } else {
    const float first = exp(-(u0 * u0 + line.e));
    const float second = exp(-(u1 * u1 + line.e));
    t = line.t0 + (first - second) / max(sqrt_pi * view_unit_depth, tiny_square) / a;
  }
  return max(min(t, min(max_t, length_)), 0.0);
}

// Airlight of the homogeneous part (eqs. 17 to 19), per unit of radiant intensity.
float fog_airlight(PaperLight light, vec3 w, float length_) {
  const float ts = dot(light.position, w);
  const vec3 offset = light.position - ts * w;
  const float offset2 = dot(offset, offset);
  const float h = max(max(sqrt(offset2), light.h_min), max(abs(ts) * light_rounding, min_light_gap));
  const float start2 = ts * ts + h * h;
  const float start = sqrt(ts * ts + offset2);
  // Beyond t_max the path exceeds the shortest one by an opaque depth.
  const float max_extra_path = fog_detour_depth / b0;
  const float min_extra_path = ts > 0.0 ? offset2 / max(start + ts, tiny) : start - ts;
  const float t_max = max_extra_path * (start + max_extra_path + start) /
                      (2.0 * (max_extra_path + min_extra_path));
  const float end = min(length_, t_max);
  // The angle at the light between start and end.
  const float span = atan(h * end, start2 - ts * end);
  // Panels double from the phase function's peak, at angle 0 between light and view or at pi.
  const float at_start = 0.5 * pi - atan(ts / h);
  const float phi_offset = anisotropy < 0.0 ? pi - (at_start + span) : at_start;
  float panel_begin = 0.0;
  float sum = 0.0;
  for (float last = fog_panel * (1.0 - abs(anisotropy)); panel_begin < span; last *= 2.0) {
    const float panel_end = clamp(last - phi_offset, 0.0, span);
    const float panel_width = panel_end - panel_begin;
    if (panel_width > 0.0) {
      float mean = 0.0;
      for (int i = 0; i < fog_nodes.length(); ++i) {
        const float angle = panel_begin + panel_width * fog_nodes[i];
        const float phi = anisotropy < 0.0 ? span - angle : angle;
        const float sine = sin(phi);
        const float t = start2 * sine / max(h * cos(phi) + ts * sine, tiny);
        const float along = t - ts;
        const float distance_ = sqrt(along * along + offset2);
        float value = exp(-b0 * (t + distance_));
        if (anisotropy != 0.0) value *= henyey_greenstein(cos_theta(along, distance_), anisotropy);
        mean += fog_weights[i] * value;
      }
      sum += panel_width * mean;
    }
    panel_begin = panel_end;
  }
  return b0 * phase * sum / h;
}

void main() {
  const uint id = gl_LocalInvocationID.x;
  const PixelOfGroup pixel = pixel_of_group();
  const vec3 w = ray_direction(pixel.position);
  const float length_ = pixel.live ? ray_length(pixel.position) : 0.0;
  const uint begin = offsets[pixel.tile];
  const uint end = offsets[pixel.tile + 1];
  float depth = 0.0;
  float scattered = 0.0;
  vec3 plain = vec3(0.0);
  vec3 conserved = vec3(0.0);
  uint pairs = 0u;
  for (uint base = begin; base < end; base += group_size) {
    barrier();
    if (base + id < end) {
      const uint i = list[base + id];
      batch[id] = seen[i];
      batch_index[id] = i;
#ifdef ELLIPSOIDS
      batch_ellipsoids[id] = ellipsoid_of(i);
#endif
    }
    barrier();
    const uint size = min(uint(group_size), end - base);
    for (uint j = 0u; j < size; ++j) {
      const SeenGaussian g = batch[j];
#ifdef ELLIPSOIDS
      const EllipsoidWarp e = batch_ellipsoids[j];
      const LineProfile line = view_line_profile(e, g.center, w, g.a, g.max_undisplaced_e);
#else
      const LineProfile line = view_line_profile(g.center, w, g.a, g.max_undisplaced_e);
#endif
      if (line.e > g.max_e) continue;
      ++pairs;
      const float half_depth = g.scale * line.share;
      const float view_unit_depth = unit_depth(line, length_);
      const float through = half_depth * view_unit_depth;
      depth += through;
      float t;
      float depth_to_point;
      if (at_mean != 0) {
        t = mean_parameter(line, length_, view_unit_depth);
        depth_to_point = half_depth * unit_depth(line, t);
      } else {
        t = clamp(line.t0, 0.0, length_);
        depth_to_point = depth_to_projection(line, half_depth, length_, through);
      }
      const int i = int(batch_index[j]);
      if (conserves != 0) {
        scattered += through * exp(-(frozen[light_count * gaussian_count + i] + depth_to_point));
      }
      const vec3 q = g.center - t * w;  // the centre relative to that point
      for (int l = 0; l < light_count; ++l) {
        const vec3 s = lights[l].position;
        const float ts = dot(s, w);
        const vec3 offset = s - ts * w;
        const float along = t - ts;
        // Attenuation uses the true length; only 1/r^2 is clamped.
        const float distance2 =
            along * along + max(dot(offset, offset), lights[l].h_min * lights[l].h_min);
        const float distance_ = sqrt(max(along * along + dot(offset, offset), tiny));
        const vec3 to_light = (s - t * w) / distance_;
#ifdef ELLIPSOIDS
        const LineProfile from_light = line_profile(e, q, to_light, g.a);
#else
        const LineProfile from_light = line_profile(q, to_light, g.a);
#endif
        const float light_depth =
            g.scale * from_light.share * unit_depth(from_light, distance_);
        float light =
            through * exp(-(frozen[l * gaussian_count + i] + depth_to_point + light_depth)) / distance2;
        if (anisotropy != 0.0) light *= henyey_greenstein(cos_theta(along, distance_), anisotropy);
        const vec3 outgoing = lights[l].intensity * (phase * light);
        if (lights[l].conserves_energy != 0) {
          conserved += outgoing;
        } else {
          plain += outgoing;
        }
      }
    }
  }
  // Gaussians of total depth T scatter 1 - exp(-T) along a ray; `scattered` is their estimate of it.
  if (scattered > tiny) {
    conserved *= (depth < small_increment ? depth - 0.5 * depth * depth : 1.0 - exp(-depth)) / scattered;
  }
  vec3 airlight = plain + conserved;
  if (b0 > 0.0) {
    for (int l = 0; l < light_count; ++l) {
      airlight += lights[l].intensity * lights[l].transmittance *
                  fog_airlight(lights[l], w, length_);
    }
    depth += b0 * length_;
  }
  store_pixel(pixel, airlight + environment_inscattering(w, depth), depth, pairs);
}
