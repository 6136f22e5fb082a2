// Depth-aware upsampling: AirlightSamples and upsample() of render/cpu/upsampling.h, for one tile. Lists
// the pixels to evaluate exactly, in batches, and curved cells.
#include "upsampling.glsl"

layout(rgba32f, binding = 1) readonly uniform image2D samples;

// The pixels nearest to lights, and where those of each tile begin: TilePixels.
layout(std430, binding = 0) restrict readonly buffer LightOffsets { uint light_offsets[]; };
layout(std430, binding = 1) restrict readonly buffer LightPixels { ivec2 light_pixels[]; };

float sample_distance(ivec2 sample_) { return distance_at(min(sample_ * scale, film - 1)); }

// Whether two distances may belong to one surface.
bool continuous(float a, float b) { return a == b || abs(a - b) < max_relative_step * min(a, b); }

float curvature_along(ivec2 sample_, ivec2 step_) {
  // Ignore differences across a depth edge; the depth test rejects those pixels.
  const float t = sample_distance(sample_);
  if (!continuous(sample_distance(sample_ - step_), t) ||
      !continuous(t, sample_distance(sample_ + step_))) {
    return 0.0;
  }
  return curvature_of(imageLoad(samples, sample_ - step_), imageLoad(samples, sample_),
                      imageLoad(samples, sample_ + step_));
}

// Error of linear interpolation next to a sample, in units of the tolerance.
float curvature(ivec2 sample_) {
  // Curvature needs three samples per axis; with fewer, never interpolate.
  float max_curvature = sample_film.x < 3 || sample_film.y < 3 ? unknown_curvature : 0.0;
  if (sample_.x > 0 && sample_.x + 1 < sample_film.x) {
    max_curvature = max(max_curvature, curvature_along(sample_, ivec2(1, 0)));
  }
  if (sample_.y > 0 && sample_.y + 1 < sample_film.y) {
    max_curvature = max(max_curvature, curvature_along(sample_, ivec2(0, 1)));
  }
  return max_curvature;
}

// AirlightSamples::LocalFit.
struct LocalFit {
  bool is_valid;
  ivec2 pixel;  // the sample's
  vec4 value, per_x, per_y;
  float t;
  vec2 t_per_pixel;
};

bool is_continuous(ivec2 first, ivec2 second) {
  return all(greaterThanEqual(second, ivec2(0))) && all(lessThan(second, sample_film)) &&
         continuous(sample_distance(first), sample_distance(second));
}

// Slopes of value and distance per pixel. False if the surface has no three samples in a row.
bool slope(ivec2 sample_, ivec2 step_, out vec4 value, out float distance_) {
  value = vec4(0.0);
  distance_ = 0.0;
  const bool has_previous = is_continuous(sample_, sample_ - step_);
  const bool has_next = is_continuous(sample_, sample_ + step_);
  if (!has_previous && !has_next) return false;
  const int center = has_previous && has_next ? 0 : has_previous ? -1 : 1;
  if (center != 0 && !is_continuous(sample_ + center * step_, sample_ + 2 * center * step_)) return false;
  // The last row and column may be spaced closer than `scale`.
  if (any(greaterThan((sample_ + (center + 1) * step_) * scale, film - 1))) return false;
  const ivec2 positions[3] = ivec2[3](sample_ + (center - 1) * step_, sample_ + center * step_,
                                      sample_ + (center + 1) * step_);
  const vec4 a = imageLoad(samples, positions[0]);
  const vec4 b = imageLoad(samples, positions[1]);
  const vec4 c = imageLoad(samples, positions[2]);
  if (!(curvature_of(a, b, c) <= max_local_fit_curvature)) return false;
  // Slope at this sample of the parabola through all three.
  const float per_pixel = 1.0 / float(scale);
  const float from_center = float(-center);
  value = per_pixel * (0.5 * (c - a) + from_center * (a + c - 2.0 * b));
  if (sample_distance(sample_) < endless) {
    const float ta = sample_distance(positions[0]);
    const float tb = sample_distance(positions[1]);
    const float tc = sample_distance(positions[2]);
    distance_ = per_pixel * (0.5 * (tc - ta) + from_center * (ta + tc - 2.0 * tb));
  }
  return true;
}

LocalFit local_fit(ivec2 sample_) {
  LocalFit s;
  s.pixel = min(sample_ * scale, film - 1);
  s.value = imageLoad(samples, sample_);
  s.t = sample_distance(sample_);
  s.is_valid = slope(sample_, ivec2(1, 0), s.per_x, s.t_per_pixel.x);
  s.is_valid = s.is_valid && slope(sample_, ivec2(0, 1), s.per_y, s.t_per_pixel.y);
  return s;
}

bool lies_on_surface(LocalFit s, ivec2 pixel, float t, float tolerance_u) {
  if (s.t >= endless) return t >= endless;
  return abs(t - (s.t + dot(vec2(pixel - s.pixel), s.t_per_pixel))) <= tolerance_u;
}

vec4 value_at(LocalFit s, ivec2 pixel) {
  const vec2 offset = vec2(pixel - s.pixel);
  const vec4 v = s.value + offset.x * s.per_x + offset.y * s.per_y;
  return max(vec4(v.xyz, min(v.w, 1.0)), 0.0);
}

struct Cell {
  ivec2 begin, end;    // pixels
  ivec2 reach;         // pixels from the first sample to the opposite one
  vec2 per_pixel;      // cells
  vec4 v00, v10, v01, v11;
  vec4 t;              // distances at the corners
  bool open, solid, is_linear;
};

Cell cell_at(ivec2 sample_, ivec2 last) {
  Cell cell;
  const ivec2 diagonal = min(sample_ + 1, sample_film - 1);
  cell.begin = min(sample_ * scale, film - 1);
  const ivec2 next = min(diagonal * scale, film - 1);
  cell.end = ivec2(sample_.x + 1 == last.x ? film.x : next.x, sample_.y + 1 == last.y ? film.y : next.y);
  cell.reach = next - cell.begin;
  cell.per_pixel = 1.0 / vec2(max(cell.reach, 1));
  const ivec2 right = ivec2(diagonal.x, sample_.y);
  const ivec2 below = ivec2(sample_.x, diagonal.y);
  cell.v00 = imageLoad(samples, sample_);
  cell.v10 = imageLoad(samples, right);
  cell.v01 = imageLoad(samples, below);
  cell.v11 = imageLoad(samples, diagonal);
  cell.t = vec4(sample_distance(sample_), sample_distance(right), sample_distance(below),
                sample_distance(diagonal));
  const bvec4 none = greaterThanEqual(cell.t, vec4(endless));
  cell.open = all(none);
  cell.solid = !any(none);
  cell.is_linear = (cell.open || cell.solid) &&
                   max(max(curvature(sample_), curvature(right)),
                       max(curvature(below), curvature(diagonal))) <= 1.0;
  return cell;
}

vec2 fractions_at(Cell cell, ivec2 pixel) { return vec2(pixel - cell.begin) * cell.per_pixel; }

bool on_sample(vec2 f) { return (f.x == 0.0 || f.x == 1.0) && (f.y == 0.0 || f.y == 1.0); }

// Whether a pixel lies at its linearly interpolated distance.
bool on_interpolated_plane(Cell cell, ivec2 pixel, float tolerance_u) {
  if (!cell.is_linear) return false;
  const vec2 f = fractions_at(cell, pixel);
  const float t = distance_at(pixel);
  const float expected = mix(mix(cell.t.x, cell.t.z, f.y), mix(cell.t.y, cell.t.w, f.y), f.x);
  return cell.solid ? abs(t - expected) <= tolerance_u : cell.open && t >= endless;
}

// From the corners whose surface a pixel is on. False if too little sample weight lies on the
// pixel's surface; evaluate it exactly.
bool of_surface(LocalFit corners[4], Cell cell, ivec2 pixel, float tolerance_u, out vec4 value) {
  const vec2 f = fractions_at(cell, pixel);
  const vec4 weights =
      vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
  const float t = distance_at(pixel);
  float weight_sum = 0.0;
  value = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    if (!corners[k].is_valid || !lies_on_surface(corners[k], pixel, t, tolerance_u)) continue;
    weight_sum += weights[k];
    value += weights[k] * value_at(corners[k], pixel);
  }
  if (weight_sum < min_surface_weight) return false;
  value /= weight_sum;
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
uint fill(Cell cell, ivec2 sample_, float tolerance_u, uint exact) {
  const ivec2 size = cell.end - cell.begin;
  uint uneven = 0u;
  for (int k = 0; k < size.x * size.y; ++k) {
    if ((exact >> k & 1u) != 0u) continue;
    const ivec2 pixel = cell.begin + ivec2(k % size.x, k / size.x);
    const vec2 f = fractions_at(cell, pixel);
    if (on_sample(f)) continue;
    if (on_interpolated_plane(cell, pixel, tolerance_u)) {
      imageStore(airlight_image, pixel,
                 mix(mix(cell.v00, cell.v01, f.y), mix(cell.v10, cell.v11, f.y), f.x));
    } else {
      uneven |= 1u << k;
    }
  }
  if (uneven == 0u) return exact;
  LocalFit corners[4];
  for (int k = 0; k < 4; ++k) {
    corners[k] = local_fit(min(sample_ + ivec2(k % 2, k / 2), sample_film - 1));
  }
  uint remaining = exact;
  for (uint bits = uneven; bits != 0u; bits &= bits - 1u) {
    const int k = findLSB(bits);
    const ivec2 pixel = cell.begin + ivec2(k % size.x, k / size.x);
    vec4 value;
    if (of_surface(corners, cell, pixel, tolerance_u, value)) {
      imageStore(airlight_image, pixel, value);
    } else {
      remaining |= 1u << k;
    }
  }
  return remaining;
}

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int tile = int(linear_group());
  if (tile >= tiles.x * tiles.y) return;  // uniform within the group
  const ivec2 last = max(sample_film - 1, ivec2(1));
  const ivec2 sample_ = ivec2(tile % tiles.x, tile / tiles.x) * ivec2(tile_width, tile_height) +
                        ivec2(id % tile_width, id / tile_width);
  const bool live = all(lessThan(sample_, last));
  const float tolerance_u = distance_tolerance(tile);
  const Cell cell = cell_at(min(sample_, sample_film - 1), last);
  const uint remaining = live ? fill(cell, sample_, tolerance_u, near_lights(cell, tile)) : 0u;
  const ivec2 size = cell.end - cell.begin;
  const bool has_lights = light_offsets[tile] < light_offsets[tile + 1];
  const bool is_curved = live && !has_lights && bitCount(remaining) > halving_samples &&
                         (cell.open || cell.solid) && cell.reach == ivec2(4) && size == ivec2(4);
  uint flags = is_curved ? curved_is_cell | (cell.open ? curved_is_open : 0u) | remaining : 0u;
  if (!is_curved && size.x > 2 && (remaining >> 2 & 1u) != 0u) flags |= evaluates_top;
  if (!is_curved && size.y > 2 && (remaining >> (2 * size.x) & 1u) != 0u) flags |= evaluates_left;
  curved_cells[tile * group_size + id] = flags;
  if (is_curved) atomicAdd(totals.curved_cells, 1u);
  list_requests(tile, is_curved ? 0u : remaining, cell.begin, size.x);
}
