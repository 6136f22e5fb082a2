// Depth-aware upsampling: film_airlight() of render/film_airlight.h. Interpolates the cells right of
// and below the samples of one tile, and lists the pixels that this is not good enough for, in
// batches for the method to take again.
#include "constants.glsl"
#include "linear.glsl"

layout(local_size_x = 128) in;

layout(r32f, binding = 0) readonly uniform image2D depths;  // to the surface; < 0: none
layout(rgba32f, binding = 1) readonly uniform image2D samples;
layout(rgba32f, binding = 2) writeonly uniform image2D airlight_image;

layout(std430, binding = 2) readonly buffer Seen { vec4 seen[]; };
layout(std430, binding = 3) readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = 4) buffer Totals {
  uint batches;
  uint asked_pixels;
  float mean_square;
};
layout(std430, binding = 5) writeonly buffer Asked { uint asked[]; };
layout(std430, binding = 6) readonly buffer Entries { uint list[]; };

uniform ivec2 film;
uniform ivec2 sample_film;
uniform ivec2 tiles;
uniform int scale;
uniform float b0;
uniform float tolerance;
uniform int capacity;    // pixels that a tile may ask for
uniform int batches_at;  // where batches begin in `asked`

const float endless = 1e30;
shared uint sums[128];
shared uint first_batch;

float distance_at(ivec2 pixel) {
  const float depth = imageLoad(depths, pixel).r;
  return depth >= 0.0 ? depth : endless;
}

float sample_distance(ivec2 at) { return distance_at(min(at * scale, film - 1)); }

// Whether two distances may belong to one surface.
bool continuous(float a, float b) { return a == b || abs(a - b) < 0.05 * min(a, b); }

// An eighth of the second difference is how far the middle between two samples is from the line
// between them; in units of what is tolerated.
float second_difference(ivec2 at, ivec2 step_, vec4 unit) {
  // Across the edge of an object, distances tell.
  const float t = sample_distance(at);
  if (!continuous(sample_distance(at - step_), t) || !continuous(t, sample_distance(at + step_))) {
    return 0.0;
  }
  const vec4 d = abs(imageLoad(samples, at - step_) + imageLoad(samples, at + step_) -
                     2.0 * imageLoad(samples, at)) *
                 unit * 0.125;
  return max(max(d.x, d.y), max(d.z, d.w));
}

// How wrong linear interpolation beside a sample is.
float bend(ivec2 at, vec4 unit) {
  // With fewer than three in a row nothing tells.
  float most = sample_film.x < 3 || sample_film.y < 3 ? 2.0 : 0.0;
  if (at.x > 0 && at.x + 1 < sample_film.x) {
    most = max(most, second_difference(at, ivec2(1, 0), unit));
  }
  if (at.y > 0 && at.y + 1 < sample_film.y) {
    most = max(most, second_difference(at, ivec2(0, 1), unit));
  }
  return most;
}

// How much nearer or farther a surface may be than interpolated without the airlight telling.
float depth_tolerance(int tile) {
  float least = b0 > 0.0 ? 0.02 / b0 : endless;
  for (uint k = offsets[tile]; k < offsets[tile + 1]; ++k) {
    least = min(least, 0.05 / seen[2 * list[k]].w);
  }
  return least;
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
  const vec4 unit = vec4(vec3(1.0 / max(tolerance * sqrt(mean_square), 1e-30)), 1.0 / tolerance);
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
                  max(max(bend(at, unit), bend(right, unit)),
                      max(bend(below, unit), bend(beside, unit))) <= 1.0;
  return cell;
}

// Whether a pixel must be asked for; otherwise `value` is what is there, if `is_new`.
bool must_ask(Cell cell, ivec2 pixel, float near, out vec4 value, out bool is_new) {
  const vec2 f = vec2(pixel - cell.begin) * cell.per_pixel;
  is_new = !((f.x == 0.0 || f.x == 1.0) && (f.y == 0.0 || f.y == 1.0));
  value = mix(mix(cell.v00, cell.v01, f.y), mix(cell.v10, cell.v11, f.y), f.x);
  if (!is_new) return false;
  const float t = distance_at(pixel);
  const float expected = mix(mix(cell.t.x, cell.t.z, f.y), mix(cell.t.y, cell.t.w, f.y), f.x);
  const bool level =
      cell.solid ? abs(t - expected) <= near : cell.open && t >= endless;
  return !cell.straight || !level;
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
  uint own = 0u;
  if (live) {
    for (int y = cell.begin.y; y < cell.end.y; ++y) {
      for (int x = cell.begin.x; x < cell.end.x; ++x) {
        vec4 value;
        bool is_new;
        if (must_ask(cell, ivec2(x, y), near, value, is_new)) {
          ++own;
        } else if (is_new) {
          imageStore(airlight_image, ivec2(x, y), value);
        }
      }
    }
  }
  // Pixels are listed cell by cell, so that neighbours share their slices.
  sums[id] = own;
  for (int step_ = 1; step_ < 128; step_ *= 2) {
    barrier();
    const uint before = id >= step_ ? sums[id - step_] : 0u;
    barrier();
    sums[id] += before;
  }
  barrier();
  const uint all_ = sums[127];
  const uint begin = uint(tile * capacity);
  uint place = begin + sums[id] - own;
  if (own > 0u) {
    for (int y = cell.begin.y; y < cell.end.y; ++y) {
      for (int x = cell.begin.x; x < cell.end.x; ++x) {
        vec4 value;
        bool is_new;
        if (must_ask(cell, ivec2(x, y), near, value, is_new)) asked[place++] = uint(x | y << 16);
      }
    }
  }
  const uint groups = (all_ + 127u) / 128u;
  if (id == 0 && all_ > 0u) {
    first_batch = atomicAdd(batches, groups);
    atomicAdd(asked_pixels, all_);
  }
  barrier();
  for (uint k = uint(id); k < groups; k += 128u) {
    const uint batch = uint(batches_at) + 3u * (first_batch + k);
    asked[batch] = uint(tile);
    asked[batch + 1u] = begin + 128u * k;
    asked[batch + 2u] = min(all_ - 128u * k, 128u);
  }
}
