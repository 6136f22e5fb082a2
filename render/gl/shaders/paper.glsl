// The paper's airlight: paper_airlight() and its kernels in render/cpu. One work group per tile, or
// per batch of exact pixels.
#include "constants.glsl"
#include "tile_list.glsl"

struct PaperLight {
  vec4 position;   // relative to the eye; h_min
  vec4 intensity;  // RGB; what Gaussians leave of its light on the way to the eye
  ivec4 options;   // whether energy is conserved
};

layout(std430, binding = 0) readonly buffer Lights { PaperLight lights[]; };
// Per light and Gaussian the optical depth from light to Gaussian to eye; then per Gaussian that to
// the eye.
layout(std430, binding = 1) readonly buffer Frozen { float frozen[]; };

#include "film.glsl"
#include "noise.glsl"
#include "glow.glsl"

uniform int light_count;
uniform int gaussian_count;
uniform float b0;
uniform float anisotropy;
uniform int at_mean;
uniform int conserves;  // whether any light conserves energy

shared vec4 batch_position[group_size];
shared vec4 batch_shape[group_size];
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
  const float u0 = clamp(-a * view.t0, -1e4, 1e4);
  const float u1 = clamp(a * (length_ - view.t0), -1e4, 1e4);
  const float k = a * length_;
  const float max_value = max(view.t0, 0.0) + 1.0 / a;
  float t;
  if (k * (1.0 + abs(u0) + abs(u1)) < 1.0) {
    // The quotient cancels on a short segment: from its middle, by the density's slope there.
    const float m = 0.5 * (u0 + u1);
    const float bend = k * k * (1.0 + m * m);
    t = 0.5 * length_ - m * k * length_ * (1.0 / 6.0 - bend / 90.0);
  } else {
    const float first = exp(-(u0 * u0 + view.e));
    const float second = exp(-(u1 * u1 + view.e));
    t = view.t0 + (first - second) / max(1.77245385 * unit_depth, 1e-37) / a;
  }
  return max(min(t, min(max_value, length_)), 0.0);
}

// Airlight of the homogeneous part (eqs. 17 to 19), per unit of radiant intensity.
float fog_airlight(vec4 light, vec3 w, float length_) {
  const float ts = dot(light.xyz, w);
  const vec3 gap = light.xyz - ts * w;
  const float gap2 = dot(gap, gap);
  const float h = max(max(sqrt(gap2), light.w), max(abs(ts) * 1e-6, 1e-15));
  const float start2 = ts * ts + h * h;
  const float start = sqrt(ts * ts + gap2);
  // Past this point the path is longer than the shortest one by a depth of 10.
  const float longer = 10.0 / b0;
  const float detour = ts > 0.0 ? gap2 / max(start + ts, 1e-30) : start - ts;
  const float cutoff_radius = longer * (start + longer + start) / (2.0 * (longer + detour));
  const float end = min(length_, cutoff_radius);
  // The angle at the light between start and end.
  const float span = atan(h * end, start2 - ts * end);
  // Panels double from the phase function's peak, at angle 0 between light and view or at pi.
  const float pi = 3.14159265;
  const float at_start = 0.5 * pi - atan(ts / h);
  const float before = anisotropy < 0.0 ? pi - (at_start + span) : at_start;
  float from = 0.0;
  float sum = 0.0;
  for (float last = 4.0 * (1.0 - abs(anisotropy)); from < span; last *= 2.0) {
    const float until = clamp(last - before, 0.0, span);
    const float part = until - from;
    if (part > 0.0) {
      float mean = 0.0;
      for (int i = 0; i < fog_nodes.length(); ++i) {
        const float angle = from + part * fog_nodes[i];
        const float phi = anisotropy < 0.0 ? span - angle : angle;
        const float sine = sin(phi);
        const float t = start2 * sine / max(h * cos(phi) + ts * sine, 1e-30);
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
      batch_position[id] = seen[2 * i];
      batch_shape[id] = seen[2 * i + 1];
      batch_index[id] = i;
    }
    barrier();
    const uint size = min(uint(group_size), end - base);
    for (uint j = 0u; j < size; ++j) {
      const vec4 g = batch_position[j];
      const vec4 shape = batch_shape[j];
      const Crossing view = view_crossing(g.xyz, w, g.w, shape.z);
      if (view.e > shape.y) continue;
      ++pairs;
      const float unit_depth = crossing_depth(view, g.w, length_);
      const float through = shape.x * unit_depth;
      depth += through;
      float t;
      float own;
      if (at_mean != 0) {
        t = mean_parameter(view, g.w, length_, unit_depth);
        own = shape.x * crossing_depth(view, g.w, t);
      } else {
        t = clamp(view.t0, 0.0, length_);
        own = depth_to_projection(view, g.w, shape.x, length_, through);
      }
      const int i = int(batch_index[j]);
      if (conserves != 0) {
        scattered += through * exp(-(frozen[light_count * gaussian_count + i] + own));
      }
      const vec3 q = g.xyz - t * w;  // the centre relative to that point
      for (int l = 0; l < light_count; ++l) {
        const vec4 s = lights[l].position;
        const float ts = dot(s.xyz, w);
        const vec3 gap = s.xyz - ts * w;
        const float along = t - ts;
        // The path is as long as it is; only the falloff has a least distance.
        const float distance2 = along * along + max(dot(gap, gap), s.w * s.w);
        const float distance_ = sqrt(max(along * along + dot(gap, gap), 1e-30));
        const vec3 to_light = (s.xyz - t * w) / distance_;
        const float light_depth =
            shape.x * crossing_depth(crossing_of(q, to_light, g.w), g.w, distance_);
        float light =
            through * exp(-(frozen[l * gaussian_count + i] + own + light_depth)) / distance2;
        if (anisotropy != 0.0) light *= henyey_greenstein(cos_theta(along, distance_), anisotropy);
        const vec3 outgoing = lights[l].intensity.rgb * (phase * light);
        if (lights[l].options.x != 0) {
          conserved += outgoing;
        } else {
          plain += outgoing;
        }
      }
    }
  }
  // What Gaussians of depth T scatter along a ray in all is 1 - exp(-T).
  if (scattered > 1e-30) {
    conserved *= (depth < 1e-3 ? depth - 0.5 * depth * depth : 1.0 - exp(-depth)) / scattered;
  }
  vec3 airlight = plain + conserved;
  if (b0 > 0.0) {
    for (int l = 0; l < light_count; ++l) {
      airlight += lights[l].intensity.rgb * lights[l].intensity.w *
                  fog_airlight(lights[l].position, w, length_);
    }
    depth += b0 * length_;
  }
  store_pixel(pixel, airlight + environment_inscattering(w, depth), depth, pairs);
}
