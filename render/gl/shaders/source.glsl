// What a medium scatters of an environment's light at a point of a view ray: SourceLookUp.
struct SourceLevel {
  vec4 first;   // of its nodes, relative to the eye; nodes per unit
  ivec4 count;  // nodes along x, y, z; where its values begin, in vec4
};

layout(std430, binding = 7) readonly buffer Source { vec4 source_values[]; };

uniform int source_levels;  // 0: there is no environment
uniform vec4 source_first[2];
uniform ivec4 source_count[2];
uniform float source_weight;

vec3 source_at(vec3 p) {
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
    const int i = count.w + (node.z * count.y + node.y) * count.x + node.x;
    sum += share.x * share.y * share.z * source_values[i].rgb;
  }
  return source_weight * sum;
}
