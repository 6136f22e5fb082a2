// Where view rays meet surfaces: RayCaster::points() of render/visibility. Positions are relative to
// the middle of the surfaces.
#include "rays.glsl"
#include "trace.glsl"

layout(std430, binding = 2) readonly buffer Hits { PixelHit hits[]; };

uniform int triangle_count;
uniform dvec3 eye;

struct SurfacePoint {
  vec3 position;
  vec3 normal;         // unit, or 0 where neither triangle nor mesh has one
  vec3 shadow_origin;  // where shadow rays start
  int surface;
  bool on_back;  // of the mesh, by its normals, else by its winding
};

int vertex_of(int triangle, int k) { return corners[3 * (triangle_count + triangle) + k].index; }

// Weights of corners lose digits on triangles that are larger than the distance, distances where
// the eye is far away.
vec3 hit_position(PixelHit hit, ivec2 pixel) {
  if (is_near(eye)) return vec3(eye + double(hit.distance) * exact_direction(pixel));
  const vec3 first = corner_of(hit.triangle, 0);
  return first + hit.u * (corner_of(hit.triangle, 1) - first) +
         hit.v * (corner_of(hit.triangle, 2) - first);
}

vec3 unit_or_none(vec3 v) {
  const float square = dot(v, v);
  return square > tiny_square ? v / sqrt(square) : vec3(0.0);
}

SurfacePoint point_of(PixelHit hit, ivec2 pixel) {
  const vec3 to_eye = -ray_direction(pixel);
  const float weights[3] = float[](1.0 - (hit.u + hit.v), hit.u, hit.v);
  vec3 at[3];
  vec3 normals[3];
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 3; ++k) {
    at[k] = corner_of(hit.triangle, k);
    normals[k] = corners[3 * (triangle_count + hit.triangle) + k].vector;
    sum += weights[k] * normals[k];
  }
  SurfacePoint point;
  point.surface = corners[3 * hit.triangle].index;
  // Lengthened first: the product of two short edges would vanish.
  vec3 geometric = unit_or_none(cross(unit_or_none(at[1] - at[0]), unit_or_none(at[2] - at[0])));
  const vec3 smooth_ = unit_or_none(sum);
  point.normal = dot(smooth_, smooth_) > 0.0 ? smooth_ : geometric;
  if (dot(geometric, to_eye) < 0.0) geometric = -geometric;
  point.position = hit_position(hit, pixel);
  point.position -= dot(point.position - at[0], geometric) * geometric;
  const float side = dot(point.normal, geometric) < 0.0 ? -1.0 : 1.0;
  point.normal *= side;
  point.on_back = side < 0.0;
  const vec3 sizes = max(abs(at[0]), max(abs(at[1]), abs(at[2])));
  const float rounding = float(position_rounding);
  const float off_plane = dot(abs(geometric), sizes) + rounding * max_component(sizes);
  point.shadow_origin = point.position + rounding * off_plane * geometric;
  for (int k = 0; k < 3; ++k) {
    // How far the point lies below the tangent plane of a corner.
    const vec3 n = side * normals[k];
    const float below = min(dot(point.position - at[k], n), 0.0);
    point.shadow_origin -= weights[k] * below * n;
  }
  return point;
}
