// The source function that a grid holds at a point of a view ray: SourceLookup, and the weights of
// SourceFunction.
#include "grid_corners.glsl"
#include "radiance_map.glsl"
#include "spherical_harmonics.glsl"

// R G B, and in the first of each node the neighbours that surfaces hide, as bits.
layout(std430, binding = 7) restrict readonly buffer Source { vec4 source_values[]; };

uniform uint source_occlusion_bits;  // NodeVisibility of the eye

uint corner_bits(int first) { return floatBitsToUint(source_values[first].w) & source_occlusion_bits; }

uniform int source_levels;  // 0: there is no grid
// Per level: position of its first node relative to the eye, and nodes per unit; nodes along x, y and
// z, and the index of its first value.
uniform vec4 source_first[max_grid_levels];
uniform ivec4 source_count[max_grid_levels];
uniform ivec4 source_eye_layers[max_grid_levels];
uniform int source_surfaces;  // whether they hide nodes from each other
uniform int source_bands;     // of a node: 1, or 4 where scattering is anisotropic
uniform float source_harmonics_scale;  // of what the grid holds
uniform vec4 source_factors;  // what the phase function makes of each band
uniform float source_scale;            // of the environment at nodes
uniform float source_lobe_scale;       // of its light along view rays
// With more than one band, nodes also hold the transmittance per cluster, and maps of the forward
// lobe per cluster begin at source_map_at.
uniform int source_map_at;
uniform int source_at_nodes;  // bit f: cluster f is attenuated as nodes hold it
uniform int source_lobe_on_rays;  // SourceFunction::has_lobe_on_rays()
uniform ivec2 source_map_size;  // 0: there are none
uniform vec2 source_rotation;  // of the maps: cosine and sine

// EyeLobe: its table begins here, of this size; 0: there is none.
uniform int eye_lobe_at;
uniform ivec4 eye_lobe_size;
uniform vec4 eye_lobe_x;
uniform vec4 eye_lobe_y;
uniform vec3 eye_lobe_forward;
uniform float eye_lobe_start;
uniform float eye_lobe_distance;

// EyeLobe::at(), of a ray from an offset.
vec3 eye_lobe(vec3 offset, vec3 w, float t) {
  if (eye_lobe_at == 0) return vec3(0.0);
  const float beyond = max(t - eye_lobe_start, 0.0);
  const vec4 on_film = vec4(offset + w / dot(w, eye_lobe_forward), 1.0);
  const vec3 place = clamp(vec3(dot(eye_lobe_x, on_film), dot(eye_lobe_y, on_film),
                                float(eye_lobe_size.z) * beyond / (beyond + eye_lobe_distance)),
                           vec3(0.0), vec3(eye_lobe_size.xyz - 1));
  const ivec3 first = min(ivec3(place), eye_lobe_size.xyz - 2);
  const vec3 f = place - vec3(first);
  const int slab = eye_lobe_size.x * eye_lobe_size.y;
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 4; ++c) {
    const ivec2 corner = ivec2(c & 1, c >> 1);
    const vec2 share = mix(1.0 - f.xy, f.xy, vec2(corner));
    const ivec2 column = first.xy + corner;
    int index = eye_lobe_at + first.z * slab + column.y * eye_lobe_size.x + column.x;
    if (t > source_values[index].w) index += slab * eye_lobe_size.z;
    sum += share.x * share.y *
           mix(source_values[index].rgb, source_values[index + slab].rgb, f.z);
  }
  return sum;
}

// LobeBroadening: four optical depths a value, from here on; 0: none.
uniform int source_broadening_at;

// LobeLoss() of render/slices/slice_kernels.
float lobe_loss(float cosine, float depth) {
  const float x = min(sqrt(max(0.5 - 0.5 * cosine, 0.0)) * float(broadening_angles - 1),
                      float(broadening_angles) - table_end);
  const float y = min(depth / (depth + broadening_depth_scale) * float(broadening_depths),
                      float(broadening_depths) - table_end);
  const ivec2 low = ivec2(x, y);
  const vec2 f = vec2(x, y) - vec2(low);
  vec2 at_angle;
  for (int i = 0; i < 2; ++i) {
    const int first = (low.x + i) * broadening_depths + low.y;
    const float a = source_values[source_broadening_at + first / 4][first % 4];
    const float b = source_values[source_broadening_at + (first + 1) / 4][(first + 1) % 4];
    at_angle[i] = mix(a, b, f.y);
  }
  return mix(at_angle.x, at_angle.y, f.x);
}

// The weights of a node for a view ray.
float source_weights[grid_functions];
vec3 source_cluster_weights[source_clusters];

bool is_at_nodes(int cluster) { return ((source_at_nodes >> cluster) & 1) != 0; }

void set_source_weights(vec3 w) {
  if (source_levels == 0) return;
  float y[sh_count];
  sh_basis(w, y);
  for (int l = 0; l < source_bands; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      source_weights[i] = source_harmonics_scale * source_factors[l] * y[i];
    }
  }
  if (source_map_size.x == 0) return;
  const MapTexels texels = map_texels(source_map_size, turned_to_map(source_rotation, w));
  for (int f = 0; f < source_clusters; ++f) {
    const ivec4 index = source_map_at + f * source_map_size.x * source_map_size.y + texels.index;
    const vec3 above = mix(source_values[index.x].rgb, source_values[index.y].rgb, texels.f.x);
    const vec3 below = mix(source_values[index.z].rgb, source_values[index.w].rgb, texels.f.x);
    const float scale = is_at_nodes(f) ? source_scale : source_lobe_scale;
    source_cluster_weights[f] = scale * mix(above, below, texels.f.y);
  }
}

vec3 source_position(int level, vec3 p) {
  return source_first[level].w * (p - source_first[level].xyz);
}

bool is_on_source(int level, vec3 coordinate) {
  return all(greaterThanEqual(coordinate, vec3(0.0))) &&
         all(lessThanEqual(coordinate, vec3(source_count[level].xyz - 1)));
}

int source_functions() { return source_bands * source_bands; }

// The cell that holds a point: where the nodes at its corners begin, and their shares.
struct SourceCell {
  int first[8];
  float weights[8];
};

SourceCell source_cell(vec3 p) {
  int level = 0;
  vec3 coordinate = source_position(0, p);
  while (level + 1 < source_levels && !is_on_source(level, coordinate)) {
    ++level;
    coordinate = source_position(level, p);
  }
  const ivec4 count = source_count[level];
  const vec3 last = vec3(count.xyz - 2);
  const vec3 x = clamp(coordinate, vec3(0.0), last + 1.0);
  const vec3 low = min(floor(x), last);
  const int node_size = source_functions() + (source_bands > 1 ? source_clusters / 4 : 0);
  SourceCell cell;
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 weight = mix(1.0 - (x - low), x - low, vec3(corner));
    const ivec3 node = ivec3(low) + corner;
    cell.first[c] = count.w + ((node.z * count.y + node.y) * count.x + node.x) * node_size;
    cell.weights[c] = weight.x * weight.y * weight.z;
  }
  if (source_surfaces != 0) {
#ifdef PARALLEL
    const vec3 to_eye = -vec3(parallel_direction);
#else
    const vec3 to_eye = -p;
#endif
    hide_corners(eye_corner(to_eye, ivec3(low), source_eye_layers[level]), cell.first, cell.weights);
  }
  return cell;
}

// Contribution of the clusters at a node that are attenuated as nodes hold it, or of the others.
vec3 source_clusters_at(int node, bool at_nodes) {
  vec3 sum = vec3(0.0);
  for (int f = 0; f < source_clusters; ++f) {
    if (is_at_nodes(f) != at_nodes) continue;
    sum += source_values[node + source_functions() + f / 4][f % 4] * source_cluster_weights[f];
  }
  return sum;
}

// `lobe_share`: of what the clusters' forward lobe scatters.
vec3 source_at(vec3 p, float lobe_share) {
  const SourceCell cell = source_cell(p);
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 8; ++c) {
    if (cell.weights[c] == 0.0) continue;
    vec3 value = vec3(0.0);
    for (int i = 0; i < source_functions(); ++i) {
      value += source_weights[i] * source_values[cell.first[c] + i].rgb;
    }
    if (source_at_nodes != 0) value += lobe_share * source_clusters_at(cell.first[c], true);
    sum += cell.weights[c] * value;
  }
  return sum;
}

// SourceFunction::lobe().
vec3 source_forward_lobe(bool from_eye, float line_depth) {
  const vec3 eye = on_ray(0.0, vec3(0.0));
  vec3 sum = vec3(0.0);
  if (from_eye && is_on_source(source_levels - 1, source_position(source_levels - 1, eye))) {
    const SourceCell cell = source_cell(eye);
    // Not unrolled: a software device would compile it for seconds more.
    const int corners = source_levels > 0 ? 8 : 0;
    for (int c = 0; c < corners; ++c) {
      sum += cell.weights[c] * source_clusters_at(cell.first[c], false);
    }
    return sum;
  }
  for (int f = 0; f < source_clusters; ++f) {
    if (!is_at_nodes(f)) sum += source_cluster_weights[f];
  }
  return from_eye ? sum : exp(-line_depth) * sum;
}
