// Rays against the triangles of a scene: TriangleBvh, and the intersection of Embree's robust
// mode, which leaves no gaps between triangles (Plücker coordinates). All is relative to the middle
// of the surfaces.
#include "corners.glsl"

// Components of directions are at least this, so that their inverse is finite.
const float min_component = 1e-20;
// Far ends of boxes, so that roundings lose no triangle.
const float far_share = 1.000001;
// Farther than any hit.
const float beyond_all = 1e38;

layout(std430, binding = 4) restrict readonly buffer Nodes { BvhNode nodes[]; };

uniform int node_count;

struct Hit {
  float t;
  float u, v;    // barycentric, of the second and third corner
  int triangle;  // < 0: none
};

// View rays, from `seen_from` or with PARALLEL defined all in that direction, see no triangle edge-on:
// see render/geometry/edge_on.h.
dvec3 seen_from = dvec3(0.0LF);
bool skips_edge_on = false;

float max_component(vec3 v) { return max(v.x, max(v.y, v.z)); }

bool is_edge_on(vec3 a, vec3 b, vec3 c) {
  const dvec3 normal = cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
#ifdef PARALLEL
  const dvec3 sizes = abs(seen_from);
  const double off = abs(dot(normal, seen_from));
#else
  const dvec3 sizes = max(dvec3(max(abs(a), max(abs(b), abs(c)))), abs(seen_from));
  const double off = abs(dot(normal, seen_from - dvec3(a)));
#endif
  return off <=
         edge_on_rounding * dot(abs(normal), sizes) +
             edge_on_share * max(sizes.x, max(sizes.y, sizes.z)) * length(normal);
}

// a x b or b x c, which are equal for edges that close: by component that which cancels less.
vec3 stable_normal(vec3 a, vec3 b, vec3 c) {
  const vec3 ab = a.zxy * b.yzx;
  const vec3 bc = b.zxy * c.yzx;
  return mix(b.yzx * c.zxy - bc, a.yzx * b.zxy - ab, lessThan(abs(ab), abs(bc)));
}

void intersect_triangle(int triangle, vec3 o, vec3 d, float tnear, inout Hit hit) {
  const vec3 v0 = corner_of(triangle, 0) - o;
  const vec3 v1 = corner_of(triangle, 1) - o;
  const vec3 v2 = corner_of(triangle, 2) - o;
  const vec3 e0 = v2 - v0;
  const vec3 e1 = v0 - v1;
  const vec3 e2 = v1 - v2;
  const float U = dot(cross(e0, v2 + v0), d);
  const float V = dot(cross(e1, v0 + v1), d);
  const float W = dot(cross(e2, v1 + v2), d);
  const float sum = U + V + W;
  const float eps = float_epsilon * abs(sum);
  if (min(min(U, V), W) < -eps && max(max(U, V), W) > eps) return;
  const vec3 normal = stable_normal(e0, e1, e2);
  const float den = 2.0 * dot(normal, d);
  if (den == 0.0) return;
  const float t = 2.0 * dot(v0, normal) / den;
  if (!(t >= tnear && t < hit.t)) return;
  if (skips_edge_on &&
      is_edge_on(corner_of(triangle, 0), corner_of(triangle, 1), corner_of(triangle, 2))) {
    return;
  }

  const float inverse = sum == 0.0 ? 0.0 : 1.0 / sum;
  hit = Hit(t, min(U * inverse, 1.0), min(V * inverse, 1.0), triangle);
}

// Where a ray enters a box; no less than `tfar` where it does not.
float entry(vec3 low, vec3 high, vec3 o, vec3 inverse, float tnear, float tfar) {
  const vec3 a = (low - o) * inverse;
  const vec3 b = (high - o) * inverse;
  const vec3 first = min(a, b);
  const vec3 last = max(a, b);
  const float t_enter = max(max(max(first.x, first.y), first.z), tnear);
  const float t_exit = far_share * min(min(last.x, last.y), last.z);
  return t_enter <= t_exit ? t_enter : tfar;
}

// The nearest hit in [tnear, tfar), or with `any` the first that is found; t = tfar for none.
Hit trace(vec3 o, vec3 d, float tnear, float tfar, bool any_hit) {
  Hit hit = Hit(tfar, 0.0, 0.0, -1);
  if (node_count == 0) return hit;
  const vec3 inverse = 1.0 / mix(d, vec3(min_component), lessThan(abs(d), vec3(min_component)));
  int stack[max_levels];
  int top = 0;
  int node = 0;
  while (node >= 0) {
    float t_entry[2];
    int next[2];
    for (int c = 0; c < 2; ++c) {
      const BvhChild child = nodes[node].children[c];
      t_entry[c] = entry(child.low, child.high, o, inverse, tnear, hit.t);
      next[c] = t_entry[c] < hit.t ? child.first : -1;
      if (next[c] < 0 || child.count == 0) continue;
      for (int k = 0; k < child.count; ++k) intersect_triangle(child.first + k, o, d, tnear, hit);
      if (any_hit && hit.triangle >= 0) return hit;
      next[c] = -1;
    }
    const bool second_first = next[1] >= 0 && (next[0] < 0 || t_entry[1] < t_entry[0]);
    node = second_first ? next[1] : next[0];
    const int other = second_first ? next[0] : next[1];
    if (other >= 0 && top < max_levels) stack[top++] = other;
    if (node < 0 && top > 0) node = stack[--top];
  }
  return hit;
}

// The nearest surface on a ray from any distance, in double up to where float will do: it starts at
// the ball around the surfaces. `skip`: how far that is. Hits nearer than `nearest` do not count.
Hit first_hit(dvec3 origin, dvec3 direction, float nearest, out double skip) {
  skip = 0.0LF;
  if (!is_near(origin)) {
    skip = max(-dot(origin, direction) - start_radii * surfaces_radius, 0.0LF);
  }
#ifdef PARALLEL
  seen_from = direction;
#else
  seen_from = origin;
#endif
  skips_edge_on = true;
  const Hit hit = trace(vec3(origin + skip * direction), vec3(direction),
                        max(nearest - float(skip), 0.0), beyond_all, false);
  skips_edge_on = false;
  return hit;
}
