// Shared by interpolate.glsl and halve.glsl: distances, tolerances, and the list of pixels to
// evaluate exactly.
#include "constants.glsl"
#include "linear.glsl"
#include "structs.glsl"
#include "ellipsoids.glsl"

layout(local_size_x = group_size) in;

layout(r32f, binding = 0) readonly uniform image2D depths;  // to the surface; < 0: none
layout(rgba32f, binding = 2) writeonly uniform image2D airlight_image;

layout(std430, binding = 2) restrict readonly buffer Seen { SeenGaussian seen[]; };
layout(std430, binding = 3) restrict readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = 4) restrict buffer Totals { UpsamplingTotals totals; };
layout(std430, binding = 5) restrict writeonly buffer Requests { uint requests[]; };
layout(std430, binding = 6) restrict readonly buffer Entries { uint list[]; };
// For each invocation of interpolate.glsl, whose cell may be curved: CurvedCell::missing and these.
layout(std430, binding = 7) restrict buffer CurvedCells { uint curved_cells[]; };

const uint curved_is_open = 1u << 16;
const uint curved_is_cell = 1u << 17;
// For other cells: whether those of their pixels are evaluated that are nodes of cells beside them.
const uint evaluates_top = 1u << 18;
const uint evaluates_left = 1u << 19;

uniform ivec2 film;
uniform ivec2 sample_film;
uniform ivec2 tiles;
uniform int scale;
uniform float b0;
uniform float tolerance;
uniform int capacity;    // pixels that a tile may request
uniform int requests_at; // where those of this run begin
uniform int batches_at;  // where batches begin in `requests`

shared uint sums[group_size];
shared uint first_batch;

float distance_at(ivec2 pixel) {
  const float depth = imageLoad(depths, pixel).r;
  return depth >= 0.0 ? depth : endless;
}

vec4 inverse_tolerance() {  // 1 / tolerance
  return vec4(vec3(1.0 / max(tolerance * sqrt(totals.mean_square), tiny)), 1.0 / tolerance);
}

// Deviation from linear of the midpoint between two samples, from three in a row, in units of the
// tolerance.
float curvature_of(vec4 a, vec4 b, vec4 c) {
  const vec4 d = abs(a + c - 2.0 * b) * inverse_tolerance() * middle_per_second_difference;
  return max(max(d.x, d.y), max(d.z, d.w));
}

// Depth difference [u] for which the airlight may still be interpolated: small against the Gaussians
// of the tile and the fog's mean free path. Called by all invocations of a tile's group, which share
// the work.
shared float distance_tolerances[group_size];

float distance_tolerance(int tile) {
  const uint id = gl_LocalInvocationID.x;
  float result = b0 > 0.0 ? free_paths_per_tolerance * tolerance / b0 : endless;
  for (uint k = offsets[tile] + id; k < offsets[tile + 1]; k += uint(group_size)) {
    float radius = 1.0 / seen[list[k]].a;
#ifdef ELLIPSOIDS
    const EllipsoidWarp e = ellipsoid_of(list[k]);
    if (is_ellipsoid(e)) radius *= e.second.z;
#endif
    result = min(result, radii_per_tolerance * tolerance * radius);
  }
  distance_tolerances[id] = result;
  for (uint half_ = uint(group_size) / 2u; half_ > 0u; half_ /= 2u) {
    barrier();
    if (id < half_) {
      distance_tolerances[id] = min(distance_tolerances[id], distance_tolerances[id + half_]);
    }
  }
  barrier();
  return distance_tolerances[0];
}

// Lists pixels of the invocations of a tile's group, called by all of them: `bits` are those of a
// rectangle at `first` with so many columns, row-major.
void list_requests(int tile, uint bits, ivec2 first, int columns) {
  const int id = int(gl_LocalInvocationID.x);
  const uint count = uint(bitCount(bits));
  // Pixels are listed cell by cell, so that neighbours share their slices.
  sums[id] = count;
  for (int step_ = 1; step_ < group_size; step_ *= 2) {
    barrier();
    const uint lower_sum = id >= step_ ? sums[id - step_] : 0u;
    barrier();
    sums[id] += lower_sum;
  }
  barrier();
  const uint total = sums[group_size - 1];
  const uint begin = uint(requests_at + tile * capacity);
  uint slot = begin + sums[id] - count;
  for (uint rest = bits; rest != 0u; rest &= rest - 1u) {
    const int k = findLSB(rest);
    const ivec2 pixel = first + ivec2(k % columns, k / columns);
    requests[slot++] = uint(pixel.x | pixel.y << 16);
  }
  const uint group = uint(group_size);
  const uint groups = (total + group - 1u) / group;
  if (id == 0 && total > 0u) {
    first_batch = atomicAdd(totals.batches, groups);
    atomicAdd(totals.asked_pixels, total);
  }
  barrier();
  for (uint k = uint(id); k < groups; k += group) {
    const uint batch = uint(batches_at) + uint(batch_size) * (first_batch + k);
    requests[batch + batch_tile] = uint(tile);
    requests[batch + batch_first] = begin + group * k;
    requests[batch + batch_count] = min(total - group * k, group);
  }
}
