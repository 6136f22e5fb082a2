// What a medium scatters of an environment's light at a point of a view ray: SourceLookUp, and the
// weights of EnvironmentSource.
#include "radiance_map.glsl"
#include "spherical_harmonics.glsl"

layout(std430, binding = 7) readonly buffer Source { vec4 source_values[]; };

uniform int source_levels;  // 0: there is no environment
// Of each level where its first node stands, relative to the eye, and nodes per unit; nodes along x,
// y and z, and where its values begin.
uniform vec4 source_first[2];
uniform ivec4 source_count[2];
uniform int source_bands;     // of a node: 1, or 4 where scattering is not alike all around
uniform vec4 source_factors;  // what the phase function makes of each band
uniform float source_scale;
// With more than one band nodes also have the transmittance of each family, and from source_map_at
// on there is a map for each of what it sends beyond the bands.
uniform int source_map_at;
uniform ivec2 source_map_size;
uniform vec2 source_rotation;  // of the maps: cosine and sine

// What a view ray makes of a node.
float source_weights[16];
vec3 source_family_weights[source_families];

void set_source_weights(vec3 w) {
  if (source_levels == 0) return;
  float y[sh_count];
  sh_basis(w, y);
  for (int l = 0; l < source_bands; ++l) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      source_weights[i] = source_scale * source_factors[l] * y[i];
    }
  }
  if (source_bands == 1) return;
  const MapTexels at = map_texels(source_map_size, turned_to_map(source_rotation, w));
  for (int f = 0; f < source_families; ++f) {
    const ivec4 index = source_map_at + f * source_map_size.x * source_map_size.y + at.index;
    const vec3 above = mix(source_values[index.x].rgb, source_values[index.y].rgb, at.f.x);
    const vec3 below = mix(source_values[index.z].rgb, source_values[index.w].rgb, at.f.x);
    source_family_weights[f] = source_scale * mix(above, below, at.f.y);
  }
}

vec3 source_at(vec3 p) {
  const int functions = source_bands * source_bands;
  const int node_size = functions + (source_bands > 1 ? source_families / 4 : 0);  // in vec4
  int level = 0;
  vec3 at = source_first[0].w * (p - source_first[0].xyz);
  if (source_levels > 1 && (any(lessThan(at, vec3(0.0))) ||
                            any(greaterThan(at, vec3(source_count[0].xyz - 1))))) {
    level = 1;
    at = source_first[1].w * (p - source_first[1].xyz);
  }
  const ivec4 count = source_count[level];
  const vec3 last = vec3(count.xyz - 2);
  const vec3 x = clamp(at, vec3(0.0), last + 1.0);
  const vec3 low = min(floor(x), last);
  const vec3 f = x - low;
  const ivec3 cell = ivec3(low);
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 share = mix(1.0 - f, f, vec3(corner_));
    const ivec3 node = cell + corner_;
    const int first = count.w + ((node.z * count.y + node.y) * count.x + node.x) * node_size;
    vec3 value = vec3(0.0);
    for (int i = 0; i < functions; ++i) value += source_weights[i] * source_values[first + i].rgb;
    for (int i = functions; i < node_size; ++i) {
      const vec4 passes = source_values[first + i];
      for (int k = 0; k < 4; ++k) {
        value += passes[k] * source_family_weights[4 * (i - functions) + k];
      }
    }
    sum += share.x * share.y * share.z * value;
  }
  return sum;
}
