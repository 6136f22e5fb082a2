// The paper's airlight: paper_airlight() and its kernels in render/cpu. One work group per tile, or
// per batch of exact pixels.
#include "constants.glsl"
#include "tile_list.glsl"

layout(std430, binding = 0) restrict readonly buffer Lights { PaperLight lights[]; };
// Per light and Gaussian the optical depth from light to Gaussian to eye; then per Gaussian that to
// the eye.
layout(std430, binding = 1) restrict readonly buffer Frozen { float frozen[]; };

#include "film.glsl"
#include "noise.glsl"
#include "environment_inscattering.glsl"
#include "view_fog.glsl"

uniform int light_count;
uniform int gaussian_count;
uniform float anisotropy;
uniform int at_mean;
uniform int conserves;  // whether any light conserves energy

shared SeenGaussian batch[group_size];
shared uint batch_index[group_size];
#ifdef ELLIPSOIDS
shared EllipsoidWarp batch_ellipsoids[group_size];
#endif

// Airlight of the homogeneous part (eqs. 17 to 19), per unit of radiant intensity.
float fog_airlight(PaperLight light, vec3 w, float length_) {
  const FogInterval in_fog = fog_on_ray(w);
  const vec3 s = from_ray(light.position) - in_fog.begin * w;
  const vec3 start = in_fog.begin * w - from_ray(fog_center);
  const FogRay ray = fog_ray(s, w, fog_overlap(in_fog, 0.0, length_), light.h_min, b0, start,
                             fog_radius);
  // Panels double from the phase function's peak, at angle 0 between light and view or at pi.
  const float phi_offset = anisotropy < 0.0 ? pi - (ray.at_start + ray.span) : ray.at_start;
  float panel_begin = 0.0;
  float sum = 0.0;
  for (float last = fog_panel * (1.0 - abs(anisotropy)); panel_begin < ray.span; last *= 2.0) {
    const float panel_end = clamp(last - phi_offset, 0.0, ray.span);
    const float panel_width = panel_end - panel_begin;
    if (panel_width > 0.0) {
      float mean = 0.0;
      for (int i = 0; i < fog_nodes.length(); ++i) {
        const float angle = panel_begin + panel_width * fog_nodes[i];
        const float phi = anisotropy < 0.0 ? ray.span - angle : angle;
        mean += fog_weights[i] * fog_light(ray, phi, b0, anisotropy);
      }
      sum += panel_width * mean;
    }
    panel_begin = panel_end;
  }
  return b0 * isotropic_phase * sum / ray.h;
}

void main() {
  const uint id = gl_LocalInvocationID.x;
  const PixelOfGroup pixel = pixel_of_group();
  const vec3 w = ray_direction(pixel.position);
  set_ray_offset(pixel.position);
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
      const LineProfile line = view_line_profile(e, from_ray(g.center), w, g.a, g.max_undisplaced_e);
#else
      const LineProfile line = view_line_profile(from_ray(g.center), w, g.a, g.max_undisplaced_e);
#endif
      if (line.e > g.max_e) continue;
      ++pairs;
      const float half_depth = half_depth_of(line, g.scale, g.a);
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
        depth_to_point = half_depth * depth_to_projection(line, length_, view_unit_depth);
      }
      const int i = int(batch_index[j]);
      if (conserves != 0) {
        scattered += through * exp(-(frozen[light_count * gaussian_count + i] + depth_to_point));
      }
      const vec3 q = from_ray(g.center) - t * w;  // the centre relative to that point
      for (int l = 0; l < light_count; ++l) {
        const vec3 s = from_ray(lights[l].position);
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
            half_depth_of(from_light, g.scale, g.a) * unit_depth(from_light, distance_);
        float light =
            through * exp(-(frozen[l * gaussian_count + i] + depth_to_point + light_depth)) / distance2;
        if (anisotropy != 0.0) light *= henyey_greenstein(cos_theta(along, distance_), anisotropy);
        const vec3 outgoing = lights[l].intensity * (isotropic_phase * light);
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
    conserved *= scattered_fraction(0.0, depth) / scattered;
  }
  vec3 airlight = plain + conserved;
  if (b0 > 0.0) {
    for (int l = 0; l < light_count; ++l) {
      airlight += lights[l].intensity * lights[l].transmittance *
                  fog_airlight(lights[l], w, length_);
    }
    depth += b0 * fog_overlap(fog_on_ray(w), 0.0, length_);
  }
  store_pixel(pixel, airlight + environment_inscattering(w, depth), depth, pairs);
}
