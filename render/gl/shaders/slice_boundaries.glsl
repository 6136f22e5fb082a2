// Where the slices of a tile's rays begin and end: choose_slices() of render/slices/slice_boundaries.h, by
// all invocations of the group together. Leaves them in boundaries[0 .. boundary_count), ascending.
shared float boundaries[max_boundaries];
shared float unsorted[max_boundaries];
shared uint unsorted_count;
shared int boundary_count;
shared float demand_rate[max_bins];
shared float demand_curvature[max_bins];
shared vec4 demand_of[group_size];  // a Gaussian: place on the ray, radius, peak, radii that matter

shared float demand_weights[group_size];

#include "center_ray.glsl"
#include "formulas.glsl"
#include "ellipsoids.glsl"

void add_boundary(float t) { unsorted[atomicAdd(unsorted_count, 1u)] = t; }

// See core_radius() of render/slices/slice_boundaries.cpp.
float core_radii(float depth) { return depth < slice_opaque ? core_radii_of_thin : sqrt(log(inverse_tail_depth * depth)); }

// The demand of a box of a Gaussian in a bin: rate and curvature.
vec2 box_demand(float bin, float t, float half_, vec2 demand, float begin, float width, int bins) {
  const vec2 ends = floor(clamp((t + vec2(-half_, half_) - begin) / width + bin_room, 0.0, float(bins)));
  return bin >= ends.x && bin <= ends.y ? demand : vec2(0.0);
}

// Where a Gaussian needs slices: slice_need() of the CPU.
struct SliceNeed {
  float t;
  float h;        // in radii
  float a;        // along the ray
  vec2 extent;    // of the whole Gaussian
};

SliceNeed slice_need(CenterRay ray, uint i, SeenGaussian g) {
  const vec3 q = from_center(ray, g.center);
  const float center = dot(q, ray.w);
#ifdef ELLIPSOIDS
  const EllipsoidWarp e = ellipsoid_of(i);
  if (is_ellipsoid(e)) {
    const mat3 warp = warp_of(e);
    const LineProfile line = warped_line_profile(warp * q, warp * ray.w, g.a);
#ifdef PARALLEL
    const float nearer = ray.width * g.a / e.second.z;
#else
    const float nearer = ray.spread * max(line.t0, 0.0) * g.a / e.second.z;
#endif
    const float along = g.cutoff_radius * reach_along(e, ray.w);
    return SliceNeed(line.t0, max(sqrt(line.e) - nearer, 0.0), line.a,
                     vec2(center - along, (center + along) * length(vec2(1.0, ray.spread))));
  }
#endif
  const vec2 nearest = nearest_pass(ray, q);
  const float h = g.a * nearest.y;
  return SliceNeed(center + exp(-h * h) * (nearest.x - center), h, g.a,
                   vec2(center, nearest.x) + vec2(-g.cutoff_radius, g.cutoff_radius));
}

// DemandingGaussians of render/slices/slice_boundaries.cpp: every so manieth, and what stands out.
struct Demanding {
  uint step_;
  float outstanding;
};

Demanding demanding_of(uint begin, uint end) {
  Demanding demanding;
  demanding.step_ = max((end - begin) / max_demanding, 1u);
  demanding.outstanding = 0.0;
  if (demanding.step_ == 1u) return demanding;  // uniform within the group
  float sum = 0.0;
  for (uint k = begin + gl_LocalInvocationID.x * demanding.step_; k < end;
       k += uint(group_size) * demanding.step_) {
    sum += seen[list[k]].scale;
  }
  const uint counted = (end - begin + demanding.step_ - 1u) / demanding.step_;
  demanding.outstanding = outstanding_demand * reduce_sum(sum) / float(counted);
  return demanding;
}

// Gaussians that the k-th of a list stands for; 0: others stand for it.
float demand_weight(Demanding demanding, uint k, float scale) {
  if (demanding.step_ == 1u || scale > demanding.outstanding) return 1.0;
  return k % demanding.step_ == 0u ? float(demanding.step_) : 0.0;
}

// Slice demand: see SliceDemand.
void find_demand(CenterRay ray, Demanding demanding, vec2 core, int bins, uint begin, uint end) {
  const int id = int(gl_LocalInvocationID.x);
  const float width = (core.y - core.x) / float(bins);
  for (int bin = id; bin < bins; bin += group_size) {
    demand_rate[bin] = 0.0;
    demand_curvature[bin] = 0.0;
  }
  for (uint base = begin; base < end; base += group_size) {
    barrier();
    demand_of[id] = vec4(0.0);
    if (base + id < end) {
      const uint i = list[base + id];
      const SeenGaussian g = seen[i];
      const SliceNeed need = slice_need(ray, i, g);
      const float t = need.t;
      // Twice the depth of a line through the center.
      const float half_depth = g.scale * g.a / need.a;
      const float half_ = core_radii(2.0 * half_depth) / need.a;
      const float weight = demand_weight(demanding, base + id - begin, g.scale);
      demand_weights[id] = weight;
      if (weight > 0.0 && t + half_ >= core.x && t - half_ <= core.y) {
        const float peak = g.scale * g.a / (0.5 * sqrt_pi) * exp(-need.h * need.h);
        const float depth = sqrt_pi * peak / need.a;
        demand_of[id] =
            vec4(t, 1.0 / need.a, peak, depth < slice_opaque ? box_radii : core_radii(depth));
      }
    }
    barrier();
    const int size = int(min(uint(group_size), end - base));
    for (int bin = id; bin < bins; bin += group_size) {
      const float position = float(bin);
      for (int j = 0; j < size; ++j) {
        const vec4 g = demand_of[j];
        if (g.w == 0.0) continue;
        const float curvature = 1.0 / (g.y * g.y);
        vec2 demand = box_demand(position, g.x, box_radii * g.y, g.z * vec2(box_share, curvature),
                                 core.x, width, bins);
        for (float k = box_radii; k < g.w; k += tail_step) {
          const float center = k + 0.5 * tail_step;
          const float density = g.z * exp(-center * center);
          demand += box_demand(position, g.x, (k + tail_step) * g.y,
                               density * vec2(1.0, 4.0 * center * center * curvature), core.x, width,
                               bins);
        }
        demand_rate[bin] += demand_weights[j] * demand.x;
        demand_curvature[bin] += demand_weights[j] * demand.y;
      }
    }
  }
  barrier();
}

// The ends of the core and the boundaries between `count` slices of equal demand. By one invocation.
void place_boundaries(vec2 core, int bins, int count) {
  const float width = (core.y - core.x) / float(bins);
  float depth = 0.0;
  float sum = 0.0;
  for (int i = 0; i < bins; ++i) {
    const float demand = demand_curvature[i] / (1.0 + clamp(depth, 0.0, max_front_depth));
    demand_curvature[i] = demand > 0.0 ? pow(demand, 1.0 / 3.0) : 0.0;
    if (depth > slice_opaque) demand_curvature[i] *= slice_opaque / depth;
    depth += demand_rate[i] * width;
    sum += demand_curvature[i];
  }
  const float base_demand = sum > 0.0 ? uniform_share * sum / float(bins) : 1.0;
  sum += base_demand * float(bins);
  add_boundary(core.x);
  float cumulative = 0.0;
  int k = 1;
  for (int i = 0; i < bins && k < count; ++i) {
    const float bin_demand = demand_curvature[i] + base_demand;
    while (k < count && sum * float(k) / float(count) <= cumulative + bin_demand) {
      add_boundary(core.x +
                   width * (float(i) + (sum * float(k) / float(count) - cumulative) / bin_demand));
      ++k;
    }
    cumulative += bin_demand;
  }
  add_boundary(core.y);
}

// Where light falls off within a medium, slices of equal angle as seen from the light.
void add_equi_angular(int l, CenterRay ray, vec2 range, int count) {
  const int k = int(gl_LocalInvocationID.x) + 1;
  const vec3 q = from_center(ray, lights[l].position);
  const vec3 w = ray.w;
  const float ts = nearest_pass(ray, q).x;
  // A light almost on the ray would put all slices at one point: half a slice is fine enough, of
  // what is near the light if the medium is endless.
  const float min_distance = light_slice_share *
                             min(range.y - range.x, light_distances * length(q - range.x * w)) / float(count);
  const float h = max(max(length(q - dot(q, w) * w), max(lights[l].h_min, min_distance)),
                      max(light_rounding * abs(ts), tiny));
  // From the light's foot on the ray, where angles are well known in single precision.
  const float begin = atan((range.x - ts) / h);
  const float span = atan((range.y - ts) / h) - begin;
  for (int i = k; i < count; i += group_size) {
    const float t = ts + h * tan(begin + span * float(i) / float(count));
    if (t > range.x && t < range.y) add_boundary(t);
  }
}

void sort_boundaries(float min_gap) {
  const int id = int(gl_LocalInvocationID.x);
  barrier();
  const int count = int(unsorted_count);
  for (int i = id; i < count; i += group_size) {
    const float boundary = unsorted[i];
    int rank = 0;
    for (int j = 0; j < count; ++j) {
      if (unsorted[j] < boundary || (unsorted[j] == boundary && j < i)) ++rank;
    }
    boundaries[rank] = boundary;
  }
  barrier();
  if (id == 0) {
    int unique_count = min(count, 1);
    for (int i = 1; i < count; ++i) {
      const float min_spacing = max(min_gap, min_gap_of_distance * boundaries[i]);
      if (!(boundaries[i] - boundaries[unique_count - 1] < min_spacing)) {
        boundaries[unique_count++] = boundaries[i];
      }
    }
    boundary_count = unique_count;
  }
  barrier();
}

// fog_demand() of the CPU: begin, end, and the density.
vec3 fog_demand(CenterRay ray) {
  if (fog_radius == 0.0) return vec3(0.0, opaque_fog_depth / b0, b0);
  const vec3 q = from_center(ray, fog_center);
  const vec2 nearest = nearest_pass(ray, q);
  const float square = fog_radius * fog_radius - nearest.y * nearest.y;
  if (!(square > 0.0)) return vec3(0.0);
  const float half_ = sqrt(square);
  const float aside = nearest.x < 0.0 ? ray.spread * nearest.y : 0.0;
  const float first = max(nearest.x - half_, 0.0);
  const float t = dot(q, ray.w);
  float h = length(q - t * ray.w) + ray.spread * max(t, 0.0);
#ifdef PARALLEL
  h += ray.width;
#endif
  const float last = max(t - sqrt(max(fog_radius * fog_radius - h * h, 0.0)), first);
  const float free_path = 1.0 / b0;
  return vec3(first, min(nearest.x + half_ + aside, last + opaque_fog_depth * free_path),
              1.0 / (free_path + (last - first)));
}

void choose_slices(CenterRay ray, uint begin, uint end, int slices, int per_light) {
  const int id = int(gl_LocalInvocationID.x);
  barrier();
  if (id == 0) {
    unsorted_count = 0u;
    boundary_count = 0;
  }
  vec2 extent = vec2(endless, 0.0);
  vec2 core = extent;
  const Demanding demanding = demanding_of(begin, end);
  for (uint k = begin + id; k < end; k += group_size) {
    const uint i = list[k];
    const SeenGaussian g = seen[i];
    const float r = g.cutoff_radius;
    if (demand_weight(demanding, k - begin, g.scale) == 0.0) {
      const vec3 q = from_center(ray, g.center);
      extent = vec2(min(extent.x, dot(q, ray.w) - r), max(extent.y, length(q) + r));
      continue;
    }
    const SliceNeed need = slice_need(ray, i, g);
    const float along = dot(from_center(ray, g.center), ray.w) - need.extent.x;
    const float half_ = min(core_radii(2.0 * g.scale * g.a / need.a) / need.a, along);
    extent = vec2(min(extent.x, need.extent.x), max(extent.y, need.extent.y));
    core = vec2(min(core.x, need.t - half_), max(core.y, need.t + half_));
  }
  const vec2 ends = vec2(0.0, ray.max_length);
  extent = clamp(vec2(reduce_min(extent.x), reduce_max(extent.y)), ends.xx, ends.yy);
  core = clamp(vec2(reduce_min(core.x), reduce_max(core.y)), ends.xx, ends.yy);
  vec2 full_range = extent;
  const vec3 fog = b0 > 0.0 ? fog_demand(ray) : vec3(0.0);
  const bool has_fog = fog.x < fog.y;
  if (has_fog) {
    const bool is_empty = !(extent.x < extent.y);
    full_range = min(vec2(is_empty ? fog.x : min(extent.x, fog.x),
                          is_empty ? fog.y : max(extent.y, fog.y)), ray.max_length);
  }
  if (!(full_range.x < full_range.y)) return;
  if (id == 0) {
    add_boundary(full_range.x);
    add_boundary(full_range.y);
  }
  if (extent.x < extent.y) {
    if (core.x < core.y) {
      const int bins = bins_per_slice * slices;
      find_demand(ray, demanding, core, bins, begin, end);
      if (id == 0) place_boundaries(core, bins, slices - 2);
    }
    if (id == 0) {
      add_boundary(extent.x);
      add_boundary(extent.y);
    }
  }
  barrier();
  const vec2 lit = has_fog ? full_range : core;
  for (int l = 0; l < light_count; ++l) {
    if (lights[l].index % points_per_demand != 0) continue;
    // A light in or near the medium; far ones are smooth along the ray.
    const vec3 q = from_center(ray, lights[l].position);
    const float ts = dot(q, ray.w);
    const float h = length(q - ts * ray.w);
    const float distance_to_range = max(max(lit.x - ts, ts - lit.y), 0.0);
    if (!(lit.x < lit.y) ||
        length(vec2(distance_to_range, h)) > near_light_share * (lit.y - lit.x)) {
      continue;
    }
    add_equi_angular(l, ray, lit, per_light);
  }
  if (has_fog) {
    // Slices of equal loss in the fog.
    const bool is_ball = fog_radius != 0.0;
    const int count = is_ball ? max(slices - 1, 1) : slices;
    const float first = min(fog.x, ray.max_length);
    const float last = is_ball ? min(fog.y, ray.max_length) : full_range.y;
    const float opacity = 1.0 - exp(-fog.z * (last - first));
    for (int k = id + (is_ball ? 0 : 1); k < count; k += group_size) {
      add_boundary(first - log(1.0 - opacity * float(k) / float(count)) / fog.z);
    }
    if (is_ball && id == 0) add_boundary(last);
  }
  sort_boundaries(min_gap_of_range * (full_range.y - full_range.x));
}
