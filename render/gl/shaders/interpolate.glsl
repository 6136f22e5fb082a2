// Depth-aware upsampling: AirlightSamples and upsample() of render/cpu/upsampling.h, for one tile. Lists
// the pixels that this is not good enough for, in batches for the method to take again.
#include "constants.glsl"
#include "linear.glsl"
#include "structs.glsl"

layout(local_size_x = group_size) in;

layout(r32f, binding = 0) readonly uniform image2D depths;  // to the surface; < 0: none
layout(rgba32f, binding = 1) readonly uniform image2D samples;
layout(rgba32f, binding = 2) writeonly uniform image2D airlight_image;

// The pixels nearest to lights, and where those of each tile begin: TilePixels.
layout(std430, binding = 0) readonly buffer LightOffsets { uint light_offsets[]; };
layout(std430, binding = 1) readonly buffer LightPixels { ivec2 light_pixels[]; };
layout(std430, binding = 2) readonly buffer Seen { SeenGaussian seen[]; };
layout(std430, binding = 3) readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = 4) buffer Totals { UpsamplingTotals totals; };
layout(std430, binding = 5) writeonly buffer Requests { uint requests[]; };
layout(std430, binding = 6) readonly buffer Entries { uint list[]; };

uniform ivec2 film;
uniform ivec2 sample_film;
uniform ivec2 tiles;
uniform int scale;
uniform float b0;
uniform float tolerance;
uniform int capacity;    // pixels that a tile may ask for
uniform int batches_at;  // where batches begin in `requests`

shared uint sums[group_size];
shared uint first_batch;

float distance_at(ivec2 pixel) {
  const float depth = imageLoad(depths, pixel).r;
  return depth >= 0.0 ? depth : endless;
}

float sample_distance(ivec2 at) { return distance_at(min(at * scale, film - 1)); }

// Whether two distances may belong to one surface.
bool continuous(float a, float b) { return a == b || abs(a - b) < continuous_share * min(a, b); }

vec4 tolerated() {  // 1 / what is tolerated
  return vec4(vec3(1.0 / max(tolerance * sqrt(totals.mean_square), tiny)), 1.0 / tolerance);
}

// How far the middle between two samples is from the line between them, from three in a row, in
// units of what is tolerated.
float curvature_of(vec4 a, vec4 b, vec4 c) {
  const vec4 d = abs(a + c - 2.0 * b) * tolerated() * middle_per_second_difference;
  return max(max(d.x, d.y), max(d.z, d.w));
}

float curvature_along(ivec2 at, ivec2 step_) {
  // Across the edge of an object, distances tell.
  const float t = sample_distance(at);
  if (!continuous(sample_distance(at - step_), t) || !continuous(t, sample_distance(at + step_))) {
    return 0.0;
  }
  return curvature_of(imageLoad(samples, at - step_), imageLoad(samples, at),
                 imageLoad(samples, at + step_));
}

// Error of linear interpolation beside a sample.
float curvature(ivec2 at) {
  float max_value = sample_film.x < 3 || sample_film.y < 3 ? unknown_curvature : 0.0;
  if (at.x > 0 && at.x + 1 < sample_film.x) max_value = max(max_value, curvature_along(at, ivec2(1, 0)));
  if (at.y > 0 && at.y + 1 < sample_film.y) max_value = max(max_value, curvature_along(at, ivec2(0, 1)));
  return max_value;
}

// AirlightSamples::Surroundings.
struct Surroundings {
  bool known;
  ivec2 pixel;  // the sample's
  vec4 value, per_x, per_y;
  float t;
  vec2 t_per_pixel;
};

bool is_continuous(ivec2 from, ivec2 to) {
  return all(greaterThanEqual(to, ivec2(0))) && all(lessThan(to, sample_film)) &&
         continuous(sample_distance(from), sample_distance(to));
}

// Of value and distance per pixel. False: not known.
bool slope(ivec2 at, ivec2 step_, out vec4 value, out float distance_) {
  value = vec4(0.0);
  distance_ = 0.0;
  const bool before = is_continuous(at, at - step_);
  const bool after = is_continuous(at, at + step_);
  if (!before && !after) return false;
  const int center = before && after ? 0 : before ? -1 : 1;
  if (center != 0 && !is_continuous(at + center * step_, at + 2 * center * step_)) return false;
  // The last ones may be nearer.
  if (any(greaterThan((at + (center + 1) * step_) * scale, film - 1))) return false;
  const ivec2 places[3] = ivec2[3](at + (center - 1) * step_, at + center * step_,
                                   at + (center + 1) * step_);
  const vec4 a = imageLoad(samples, places[0]);
  const vec4 b = imageLoad(samples, places[1]);
  const vec4 c = imageLoad(samples, places[2]);
  if (!(curvature_of(a, b, c) <= max_curvature_of_surroundings)) return false;
  // Of the parabola through all three, at this one.
  const float each = 1.0 / float(scale);
  const float from_center = float(-center);
  value = each * (0.5 * (c - a) + from_center * (a + c - 2.0 * b));
  if (sample_distance(at) < endless) {
    const float ta = sample_distance(places[0]);
    const float tb = sample_distance(places[1]);
    const float tc = sample_distance(places[2]);
    distance_ = each * (0.5 * (tc - ta) + from_center * (ta + tc - 2.0 * tb));
  }
  return true;
}

Surroundings surroundings(ivec2 at) {
  Surroundings s;
  s.pixel = min(at * scale, film - 1);
  s.value = imageLoad(samples, at);
  s.t = sample_distance(at);
  s.known = slope(at, ivec2(1, 0), s.per_x, s.t_per_pixel.x);
  s.known = s.known && slope(at, ivec2(0, 1), s.per_y, s.t_per_pixel.y);
  return s;
}

bool shows(Surroundings s, ivec2 pixel, float t, float near) {
  if (s.t >= endless) return t >= endless;
  return abs(t - (s.t + dot(vec2(pixel - s.pixel), s.t_per_pixel))) <= near;
}

vec4 value_at(Surroundings s, ivec2 pixel) {
  const vec2 away = vec2(pixel - s.pixel);
  const vec4 v = s.value + away.x * s.per_x + away.y * s.per_y;
  return max(vec4(v.xyz, min(v.w, 1.0)), 0.0);
}

// How much nearer or farther a surface may be than expected without the airlight telling.
float depth_tolerance(int tile) {
  float min_value = b0 > 0.0 ? free_paths_per_tolerance * tolerance / b0 : endless;
  for (uint k = offsets[tile]; k < offsets[tile + 1]; ++k) {
    min_value = min(min_value, radii_per_tolerance * tolerance / seen[list[k]].a);
  }
  return min_value;
}

struct Cell {
  ivec2 begin, end;    // pixels
  vec2 per_pixel;      // cells
  vec4 v00, v10, v01, v11;
  vec4 t;              // distances at the corners
  bool open, solid, straight;
};

Cell cell_at(ivec2 at, ivec2 last) {
  Cell cell;
  const ivec2 beside = min(at + 1, sample_film - 1);
  cell.begin = min(at * scale, film - 1);
  const ivec2 next = min(beside * scale, film - 1);
  cell.end = ivec2(at.x + 1 == last.x ? film.x : next.x, at.y + 1 == last.y ? film.y : next.y);
  cell.per_pixel = 1.0 / vec2(max(next - cell.begin, 1));
  const ivec2 right = ivec2(beside.x, at.y);
  const ivec2 below = ivec2(at.x, beside.y);
  cell.v00 = imageLoad(samples, at);
  cell.v10 = imageLoad(samples, right);
  cell.v01 = imageLoad(samples, below);
  cell.v11 = imageLoad(samples, beside);
  cell.t = vec4(sample_distance(at), sample_distance(right), sample_distance(below),
                sample_distance(beside));
  const bvec4 none = greaterThanEqual(cell.t, vec4(endless));
  cell.open = all(none);
  cell.solid = !any(none);
  cell.straight = (cell.open || cell.solid) &&
                  max(max(curvature(at), curvature(right)), max(curvature(below), curvature(beside))) <= 1.0;
  return cell;
}

vec2 shares_at(Cell cell, ivec2 pixel) { return vec2(pixel - cell.begin) * cell.per_pixel; }

bool on_sample(vec2 f) { return (f.x == 0.0 || f.x == 1.0) && (f.y == 0.0 || f.y == 1.0); }

// Whether a pixel is where linear interpolation has it.
bool is_level(Cell cell, ivec2 pixel, float near) {
  if (!cell.straight) return false;
  const vec2 f = shares_at(cell, pixel);
  const float t = distance_at(pixel);
  const float expected = mix(mix(cell.t.x, cell.t.z, f.y), mix(cell.t.y, cell.t.w, f.y), f.x);
  return cell.solid ? abs(t - expected) <= near : cell.open && t >= endless;
}

// From the corners whose surface a pixel is on. False: they do not tell.
bool of_surface(Surroundings corners[4], Cell cell, ivec2 pixel, float near, out vec4 value) {
  const vec2 f = shares_at(cell, pixel);
  const vec4 shares =
      vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
  const float t = distance_at(pixel);
  float share = 0.0;
  value = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    if (!corners[k].known || !shows(corners[k], pixel, t, near)) continue;
    share += shares[k];
    value += shares[k] * value_at(corners[k], pixel);
  }
  if (share < min_surface_share) return false;
  value /= share;
  return true;
}

bool is_sample(ivec2 pixel) {
  return all(equal(mix(pixel % scale, ivec2(0), equal(pixel, film - 1)), ivec2(0)));
}

// Which of a cell's pixels are nearest to a light, a bit for each.
uint near_lights(Cell cell, int tile) {
  uint bits = 0u;
  const int columns = cell.end.x - cell.begin.x;
  for (uint k = light_offsets[tile]; k < light_offsets[tile + 1]; ++k) {
    const ivec2 pixel = light_pixels[k];
    if (any(lessThan(pixel, cell.begin)) || any(greaterThanEqual(pixel, cell.end))) continue;
    if (is_sample(pixel)) continue;
    bits |= 1u << ((pixel.y - cell.begin.y) * columns + pixel.x - cell.begin.x);
  }
  return bits;
}

// Fills a cell's pixels. Returns a bit mask of pixels to evaluate exactly, row-major.
uint fill(Cell cell, ivec2 at, float near, uint exact) {
  const ivec2 size = cell.end - cell.begin;
  uint uneven = 0u;
  for (int k = 0; k < size.x * size.y; ++k) {
    if ((exact >> k & 1u) != 0u) continue;
    const ivec2 pixel = cell.begin + ivec2(k % size.x, k / size.x);
    const vec2 f = shares_at(cell, pixel);
    if (on_sample(f)) continue;
    if (is_level(cell, pixel, near)) {
      imageStore(airlight_image, pixel,
                 mix(mix(cell.v00, cell.v01, f.y), mix(cell.v10, cell.v11, f.y), f.x));
    } else {
      uneven |= 1u << k;
    }
  }
  if (uneven == 0u) return exact;
  Surroundings corners[4];
  for (int k = 0; k < 4; ++k) {
    corners[k] = surroundings(min(at + ivec2(k % 2, k / 2), sample_film - 1));
  }
  uint left = exact;
  for (uint bits = uneven; bits != 0u; bits &= bits - 1u) {
    const int k = findLSB(bits);
    const ivec2 pixel = cell.begin + ivec2(k % size.x, k / size.x);
    vec4 value;
    if (of_surface(corners, cell, pixel, near, value)) {
      imageStore(airlight_image, pixel, value);
    } else {
      left |= 1u << k;
    }
  }
  return left;
}

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int tile = int(linear_group());
  if (tile >= tiles.x * tiles.y) return;  // all of the group alike
  const ivec2 last = max(sample_film - 1, ivec2(1));
  const ivec2 at = ivec2(tile % tiles.x, tile / tiles.x) * ivec2(tile_width, tile_height) +
                   ivec2(id % tile_width, id / tile_width);
  const bool live = all(lessThan(at, last));
  const float near = depth_tolerance(tile);
  const Cell cell = cell_at(min(at, sample_film - 1), last);
  const uint left = live ? fill(cell, at, near, near_lights(cell, tile)) : 0u;
  const uint own = uint(bitCount(left));
  // Pixels are listed cell by cell, so that neighbours share their slices.
  sums[id] = own;
  for (int step_ = 1; step_ < group_size; step_ *= 2) {
    barrier();
    const uint before = id >= step_ ? sums[id - step_] : 0u;
    barrier();
    sums[id] += before;
  }
  barrier();
  const uint all_ = sums[group_size - 1];
  const uint begin = uint(tile * capacity);
  uint place = begin + sums[id] - own;
  const int columns = cell.end.x - cell.begin.x;
  for (uint bits = left; bits != 0u; bits &= bits - 1u) {
    const int k = findLSB(bits);
    const ivec2 pixel = cell.begin + ivec2(k % columns, k / columns);
    requests[place++] = uint(pixel.x | pixel.y << 16);
  }
  const uint group = uint(group_size);
  const uint groups = (all_ + group - 1u) / group;
  if (id == 0 && all_ > 0u) {
    first_batch = atomicAdd(totals.batches, groups);
    atomicAdd(totals.asked_pixels, all_);
  }
  barrier();
  for (uint k = uint(id); k < groups; k += group) {
    const uint batch = uint(batches_at) + uint(batch_size) * (first_batch + k);
    requests[batch + batch_tile] = uint(tile);
    requests[batch + batch_first] = begin + group * k;
    requests[batch + batch_count] = min(all_ - group * k, group);
  }
}
