// The sliced airlight: sliced_airlight() of render/cpu and sum_slices() of render/lighting. One work
// group per tile, or per batch of exact pixels. OPTICS is defined for Gaussians with optics of their
// own.
#include "constants.glsl"
#include "tile_list.glsl"

#include "film.glsl"
#include "noise.glsl"
#include "lights.glsl"
#include "shadows.glsl"
#include "ray_slices.glsl"
#include "increments.glsl"
#include "center_ray.glsl"
#include "source.glsl"
#include "compact.glsl"
#include "view_fog.glsl"

uniform float anisotropy;
uniform float negligible;
uniform float light_extinction;  // factor of optical depths towards lights
uniform float view_extinction;   // see SliceScattering
// The forward lobe is attenuated along a ray by so much per optical depth of Gaussians and fog: see
// SumAlongRays(). Not computed here, where they would take registers from all frames.
uniform float ray_per_gaussians, ray_per_fog;
uniform float truncated_phase[4];
uniform float albedo;

// The length of a ray without an end, whose products with exponents are still floats.
const float endless_line = 1e18;

#ifdef OPTICS
// Emission and albedo of Gaussians; see RelativeOptics.
layout(rgba32f, binding = 6) readonly uniform image2D optics;
shared vec4 batch_optics[group_size];
shared vec4 spilled_optics[chunk * group_size];
#endif

shared SeenGaussian batch[group_size];
#ifdef ELLIPSOIDS
shared EllipsoidWarp batch_ellipsoids[group_size];
#endif
// A range of the chunk in two bytes, and in a third whether it counts. Packed, since OpenGL 4.5
// guarantees a group no more than 32,768 bytes.
shared int batch_slices[group_size];
shared float spilled[chunk * group_size];
shared float spilled_moments[chunk * group_size];

// The slices of the chunk at `first` that any ray of the group may meet Gaussian i in, and whether
// it counts there: once over all chunks.
ivec3 slices_of(uint i, CenterRay ray, int first, int last) {
  const SeenGaussian g = seen[i];
  // A ray that is off the middle one by d meets it at most |d| h + |d|^2 t / 2 before or after.
  const vec3 q = from_center(ray, g.center);
  const float t = dot(q, ray.w);
  const float h = length(q - t * ray.w);
  const float slack =
      sqrt(g.max_e) / g.a + ray.spread * (h + 0.5 * ray.spread * abs(t));
  const ivec2 range = touched_slices(t - slack, t + slack, first, last);
  return ivec3(range, first == 0 || t - slack >= farthest[first] ? 1 : 0);
}

#ifdef ANISOTROPIC
// What a slice scatters: the fractions of the whole and of the truncated phase function, and the
// optical depth of the path by its middle.
struct SliceScattering {
  float whole, truncated;
  float path;
};

float scattered_by(float cosine, SliceScattering slice) {
  float phase_function = henyey_greenstein(cosine, anisotropy);
  if (source_broadening_at > 0) phase_function -= lobe_loss(cosine, albedo * slice.path);
  if (view_extinction == 1.0) return slice.whole * phase_function;
  float truncated = truncated_phase[3];
  for (int i = 2; i >= 0; --i) truncated = truncated * cosine + truncated_phase[i];
  return slice.whole * phase_function + (slice.truncated - slice.whole) * truncated;
}

// MeanOfWidePart() of render/slices/slice_falloff-inl.h gives this of one part, divided by its length
// and the distance h.
float scattered_over_angle(int l, vec3 along, vec3 across, float h2, float begin, float end,
                           float panel, SliceScattering slice) {
  if (!(end > begin)) return 0.0;
  const float h = sqrt(h2);
  const AnglesOfPart part = angles_of_part(begin, end, h, panel);
  const bool is_isotropic = lights[l].falloff_shape == falloff_isotropic;
  float sum = 0.0;
  for (int i = 0; i < part.panels; ++i) {
    for (int k = 0; k < 3; ++k) {
      const float theta = angle_of_node(part, i, k);
      const float sine = sin(theta);
      const float falloff =
          is_isotropic ? 1.0
                       : falloff_at_angle(l, along, across, sine, max(cos(theta), tiny), h);
      sum += weight_of_node(part, k) * falloff * scattered_by(-sine, slice);
    }
  }
  return sum;
}
#endif

void main() {
  const uint id = gl_LocalInvocationID.x;
  const PixelOfGroup pixel = pixel_of_group();
  const vec3 w = ray_direction(pixel.position);
  const float length_ = pixel.live ? ray_length(pixel.position) : 0.0;
  const uint begin = offsets[pixel.tile];
  const uint end = offsets[pixel.tile + 1];
  set_ray_offset(pixel.position);
  const CenterRay ray = center_ray(pixel.live, w);
  set_source_weights(w);
  find_slice_bounds(pixel.tile);
  const SlicePosition position = slice_position(pixel.tile, pixel.position);

  const int last = boundary_count - 1;
  float depth = 0.0;
  vec3 airlight = vec3(0.0);
  vec3 scattered = vec3(0.0);
  float lookup_weight = 0.0;
  float lookup_position = 0.0;  // times weight
  float lobe_weight = 0.0;      // SliceWeights::lobe_lookups
  uint pairs = 0u;
  float boundary = last > 0 ? slice_boundary(position, 0) : 0.0;
  float t_begin = min(boundary, length_);
  // SliceWeights::along_rays.
  const bool has_lobe_on_rays = source_levels > 0 && source_lobe_on_rays != 0;
  const bool needs_line = has_lobe_on_rays && anisotropy > 0.0;
  float along_ray = 0.0;
  float line_depth = 0.0;  // of all Gaussians, also behind surfaces
  const FogInterval in_fog = fog_on_ray(w);
  float transmittance_in = exp(-ray_per_fog * b0 * fog_overlap(in_fog, 0.0, t_begin));
  for (int first = 0; first < last; first += chunk) {
    float increments[chunk];
    float moments[chunk];
    float ends[chunk + 1];
    for (int k = 0; k < chunk; ++k) increments[k] = moments[k] = 0.0;
#ifdef OPTICS
    vec4 optics_increments[chunk];  // times optics
    for (int k = 0; k < chunk; ++k) optics_increments[k] = vec4(0.0);
#endif
    ends[0] = t_begin;
    for (int k = 0; k < chunk; ++k) {
      // Rounding must not turn slices round.
      boundary = max(boundary, slice_boundary(position, min(first + k + 1, last)));
      ends[k + 1] = min(boundary, length_);
    }
    for (uint base = begin; base < end; base += group_size) {
      barrier();  // what the group has found before is read below
      uint i = 0u;
      ivec3 range = ivec3(0);
      bool matters = base + id < end;
      if (matters) {
        i = list[base + id];
        range = slices_of(i, ray, first, last);
        matters = range.x < range.y || (needs_line && first == 0);
      }
      uint found;
      const uint slot = compact_slot(matters, found);
      if (matters) {
        batch[slot] = seen[i];
        batch_slices[slot] = range.x | range.y << 8 | range.z << 16;
#ifdef ELLIPSOIDS
        batch_ellipsoids[slot] = ellipsoid_of(i);
#endif
#ifdef OPTICS
        batch_optics[slot] = imageLoad(optics, ivec2(i % optics_width, i / optics_width));
#endif
      }
      barrier();
      for (uint j = 0u; j < found; ++j) {
        const SeenGaussian g = batch[j];
#ifdef ELLIPSOIDS
        const LineProfile line =
            view_line_profile(batch_ellipsoids[j], from_ray(g.center), w, g.a, g.max_undisplaced_e);
#else
        const LineProfile line = view_line_profile(from_ray(g.center), w, g.a, g.max_undisplaced_e);
#endif
        if (line.e > g.max_e) continue;
        const float half_depth = half_depth_of(line, g.scale, g.a);
        const ivec2 touched = ivec2(batch_slices[j] & 255, batch_slices[j] >> 8 & 255);
        pairs += uint(batch_slices[j] >> 16);
        if (needs_line && first == 0) {
          line_depth += half_depth * unit_depth(line, endless_line);
        }
#ifdef OPTICS
        float own[chunk];
        for (int k = 0; k < chunk; ++k) own[k] = 0.0;
        add_increments(own, moments, line, half_depth, ends, touched);
        for (int k = 0; k < chunk; ++k) {
          increments[k] += own[k];
          optics_increments[k] += own[k] * batch_optics[j];
        }
#else
        add_increments(increments, moments, line, half_depth, ends, touched);
#endif
      }
    }
    // Shared memory, as the loop below indexes slices dynamically, which registers cannot be.
    for (int k = 0; k < chunk; ++k) {
      spilled[k * group_size + id] = increments[k];
      spilled_moments[k * group_size + id] = moments[k];
#ifdef OPTICS
      spilled_optics[k * group_size + id] = optics_increments[k];
#endif
    }
    const int count = min(chunk, last - first);
    for (int k = 0; k < count; ++k) {
      const float t_end = min(max(slice_boundary(position, first + k + 1), t_begin), length_);
      const float gaussians = max(spilled[k * group_size + id], 0.0);
      const float fog = b0 * fog_overlap(in_fog, t_begin, t_end);
      const float increment = fog + gaussians;
#ifdef OPTICS
      const vec4 own = max(spilled_optics[k * group_size + id], vec4(0.0));
      const float scattering = fog + own.w;
#else
      const float scattering = increment;
#endif
      if (has_lobe_on_rays) {
        const float exponent = ray_per_gaussians * gaussians + ray_per_fog * fog;
        const float transmittance_out = transmittance_in * exp(-exponent);
        along_ray += scattering * mean_transmittance(exponent, transmittance_in, transmittance_out);
        transmittance_in = transmittance_out;
      }
      if (increment > negligible && view_extinction * depth < visible_depth) {
        float whole_fraction = scattered_fraction(depth, increment);
        float truncated_fraction = whole_fraction;
        if (view_extinction != 1.0) {
          truncated_fraction =
              scattered_fraction(view_extinction * depth, view_extinction * increment) /
              view_extinction;
        }
#ifdef OPTICS
        airlight += whole_fraction / max(increment, tiny) * own.rgb;
        whole_fraction *= scattering / max(increment, tiny);
        truncated_fraction *= scattering / max(increment, tiny);
#endif
        // The slice holds fog evenly, as far as that goes.
        const float middle_of_fog = 0.5 * (max(t_begin, in_fog.begin) + min(t_end, in_fog.end));
        const float moment = fog * middle_of_fog + spilled_moments[k * group_size + id];
        const LitPart part = lit_part(t_begin, t_end, increment, moment);
        lookup_weight += truncated_fraction;
        lookup_position += truncated_fraction * part.center;
        lobe_weight += whole_fraction;
        for (int l = 0; l < light_count; ++l) {
          const vec3 s = from_ray(lights[l].position);
          const float ts = dot(s, w);
          const vec3 offset = s - ts * w;
          const float h2 = max(dot(offset, offset), max(lights[l].h_min * lights[l].h_min, tiny));
          float falloff;
          float middle = part.center;
          const float begin_ = part.center - part.half_length - ts;
          const float end_ = part.center + part.half_length - ts;
          const bool is_isotropic = lights[l].falloff_shape == falloff_isotropic;
          const float unattenuated = mean_inverse_square(begin_, end_, h2);
          const float angle = unattenuated * (end_ - begin_) * sqrt(h2);
          vec3 along_light = vec3(0.0);
          vec3 across_light = vec3(0.0);
          if (is_isotropic) {
            falloff = unattenuated;
          } else {
            along_light = in_profile(l, w);
            across_light = in_profile(l, offset);
            const vec2 mean = falloff_mean(l, along_light, across_light, begin_, end_, h2, angle);
            if (!(mean.x > 0.0)) continue;
            falloff = mean.x;
            middle = ts + mean.y;
          }
          const float along = middle - ts;
          const float distance_ = sqrt(along * along + h2);
          const vec3 point = on_ray(middle, w);
          const vec3 q = point - lights[l].map_origin.xyz;
          float light_depth = b0 * length_in_fog(l, point, (middle * w - s) / distance_, distance_);
          if (lights[l].has_table != 0) light_depth += table_depth(l, q, distance_);
          float light = exp(-light_extinction * light_depth);
          float reaching = falloff * whole_fraction;
#ifdef ANISOTROPIC
          {
            const SliceScattering slice = SliceScattering(
                whole_fraction, truncated_fraction, depth + 0.5 * increment + light_depth);
            const float panel = phase_panel * (1.0 - abs(anisotropy));
            if (angle > wide_phase * panel) {
              const float[6] ends =
                  smooth_parts(l, along_light, across_light, h2, begin_, end_);
              float sum = 0.0;
              for (int i = 0; i < (is_isotropic ? 1 : 5); ++i) {
                sum += scattered_over_angle(l, along_light, across_light, h2, ends[i], ends[i + 1],
                                            is_isotropic ? panel : min(panel, smooth_panel(l)),
                                            slice);
              }
              reaching = sum / max(sqrt(h2) * (end_ - begin_), tiny);
            } else {
              reaching = falloff * scattered_by(cos_theta(along, distance_), slice);
            }
          }
#endif
          if (lights[l].has_shadows != 0) light *= lit(l, q, distance_);
          airlight += lights[l].intensity * (isotropic_phase * reaching * light);
        }
      }
      depth += increment;
      t_begin = t_end;
      // Neighbouring slices share a look-up at their mean position.
      const int next = first + k + 1;
      if (source_levels > 0 && lookup_weight > 0.0 &&
          (next % 2 == 0 || next == last)) {
        const float t = lookup_position / lookup_weight;
        scattered += lookup_weight * (source_at(on_ray(t, w), lobe_weight / lookup_weight) +
                                      eye_lobe(on_ray(0.0, w), w, t));
        lookup_weight = 0.0;
        lobe_weight = 0.0;
        lookup_position = 0.0;
      }
    }
  }
  if (has_lobe_on_rays) {
    if (fog_radius != 0.0) line_depth += b0 * (in_fog.end - in_fog.begin);
    scattered += along_ray * source_forward_lobe(anisotropy < 0.0, light_extinction * line_depth);
  }
  // Homogeneous fog continues behind the last slice; the Gaussians do not.
  if (b0 > 0.0 && last > 0) depth += b0 * fog_overlap(in_fog, t_begin, length_);
  store_pixel(pixel, airlight + max(scattered, vec3(0.0)), depth, pairs);
}
