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

// The own depth of a Gaussian up to the projection of its centre on the ray, clamped to the ray.
float depth_to_projection(Crossing view, float a, float scale_, float length_, float depth) {
  if (view.t0 <= 0.0) return 0.0;
  if (view.t0 >= length_) return depth;
  const float u = a * view.t0;
  const float before = u < 1.0 ? exp(-view.e) * erf_small(u)
                               : exp(-view.e) - scaled_erfc(view.e, u);
  return scale_ * max(before, 0.0);
}

// The mean parameter of a Gaussian on [0, length_], in that interval: Crossing::Mean().
float mean_parameter(Crossing view, float a, float length_, float unit_depth) {
  const float u0 = clamp(-a * view.t0, -erfc_end, erfc_end);
  const float u1 = clamp(a * (length_ - view.t0), -erfc_end, erfc_end);
  const float k = a * length_;
  const float max_value = max(view.t0, 0.0) + 1.0 / a;
  float t;
  if (k * (1.0 + abs(u0) + abs(u1)) < 1.0) {
    // The quotient cancels on a short segment: from its middle, by the density's slope there.
    const float m = 0.5 * (u0 + u1);
    const float bend = k * k * (1.0 + m * m);
    t = 0.5 * length_ - m * k * length_ * (mean_shift[0] - bend * mean_shift[1]);
  } else {
    const float first = exp(-(u0 * u0 + view.e));
    const float second = exp(-(u1 * u1 + view.e));
    t = view.t0 + (first - second) / max(sqrt_pi * unit_depth, tiny_square) / a;
  }
  return max(min(t, min(max_value, length_)), 0.0);
}

// Airlight of the homogeneous part (eqs. 17 to 19), per unit of radiant intensity.
float fog_airlight(PaperLight light, vec3 w, float length_) {
  const float ts = dot(light.position, w);
  const vec3 gap = light.position - ts * w;
  const float gap2 = dot(gap, gap);
  const float h = max(max(sqrt(gap2), light.h_min), max(abs(ts) * light_rounding, min_light_gap));
  const float start2 = ts * ts + h * h;
  const float start = sqrt(ts * ts + gap2);
  // Past this point the path is longer than the shortest one by too much.
  const float longer = fog_detour_depth / b0;
  const float detour = ts > 0.0 ? gap2 / max(start + ts, tiny) : start - ts;
  const float cutoff_radius = longer * (start + longer + start) / (2.0 * (longer + detour));
  const float end = min(length_, cutoff_radius);
  // The angle at the light between start and end.
  const float span = atan(h * end, start2 - ts * end);
  // Panels double from the phase function's peak, at angle 0 between light and view or at pi.
  const float at_start = 0.5 * pi - atan(ts / h);
  const float before = anisotropy < 0.0 ? pi - (at_start + span) : at_start;
  float from = 0.0;
  float sum = 0.0;
  for (float last = fog_panel * (1.0 - abs(anisotropy)); from < span; last *= 2.0) {
    const float until = clamp(last - before, 0.0, span);
    const float part = until - from;
    if (part > 0.0) {
      float mean = 0.0;
      for (int i = 0; i < fog_nodes.length(); ++i) {
        const float angle = from + part * fog_nodes[i];
        const float phi = anisotropy < 0.0 ? span - angle : angle;
        const float sine = sin(phi);
        const float t = start2 * sine / max(h * cos(phi) + ts * sine, tiny);
        const float along = t - ts;
        const float distance_ = sqrt(along * along + gap2);
        float value = exp(-b0 * (t + distance_));
        if (anisotropy != 0.0) value *= henyey_greenstein(cos_theta(along, distance_), anisotropy);
        mean += fog_weights[i] * value;
      }
      sum += part * mean;
    }
    from = until;
  }
  return b0 * phase * sum / h;
}

void main() {
  const uint id = gl_LocalInvocationID.x;
  const PixelOfGroup pixel = pixel_of_group();
  const vec3 w = ray_direction(pixel.at);
  const float length_ = pixel.live ? ray_length(pixel.at) : 0.0;
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
    }
    barrier();
    const uint size = min(uint(group_size), end - base);
    for (uint j = 0u; j < size; ++j) {
      const SeenGaussian g = batch[j];
      const Crossing view = view_crossing(g.center, w, g.a, g.displaced_cutoff);
      if (view.e > g.cutoff) continue;
      ++pairs;
      const float unit_depth = crossing_depth(view, g.a, length_);
      const float through = g.scale * unit_depth;
      depth += through;
      float t;
      float own;
      if (at_mean != 0) {
        t = mean_parameter(view, g.a, length_, unit_depth);
        own = g.scale * crossing_depth(view, g.a, t);
      } else {
        t = clamp(view.t0, 0.0, length_);
        own = depth_to_projection(view, g.a, g.scale, length_, through);
      }
      const int i = int(batch_index[j]);
      if (conserves != 0) {
        scattered += through * exp(-(frozen[light_count * gaussian_count + i] + own));
      }
      const vec3 q = g.center - t * w;  // the centre relative to that point
      for (int l = 0; l < light_count; ++l) {
        const vec3 s = lights[l].position;
        const float ts = dot(s, w);
        const vec3 gap = s - ts * w;
        const float along = t - ts;
        // The path is as long as it is; only the falloff has a least distance.
        const float distance2 = along * along + max(dot(gap, gap), lights[l].h_min * lights[l].h_min);
        const float distance_ = sqrt(max(along * along + dot(gap, gap), tiny));
        const vec3 to_light = (s - t * w) / distance_;
        const float light_depth =
            g.scale * crossing_depth(crossing_of(q, to_light, g.a), g.a, distance_);
        float light =
            through * exp(-(frozen[l * gaussian_count + i] + own + light_depth)) / distance2;
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
  // What Gaussians of depth T scatter along a ray in all is 1 - exp(-T).
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
