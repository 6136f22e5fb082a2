// Where view rays meet surfaces: RayCaster::points() of render/visibility. Positions are relative to
// the middle of the surfaces.
#include "corners.glsl"
#include "formulas.glsl"
#include "rays.glsl"

layout(std430, binding = 2) restrict readonly buffer Hits { PixelHit hits[]; };

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
  const dvec3 start = eye + exact_offset(pixel);
  if (is_near(start)) return vec3(start + double(hit.distance) * exact_direction(pixel));
  const vec3 first = corner_of(hit.triangle, 0);
  return first + hit.u * (corner_of(hit.triangle, 1) - first) +
         hit.v * (corner_of(hit.triangle, 2) - first);
}

SurfacePoint point_of(PixelHit hit, ivec2 pixel) {
  CornersAtPoint corners_;
  for (int k = 0; k < 3; ++k) {
    corners_.positions[k] = corner_of(hit.triangle, k);
    corners_.normals[k] = corners[3 * (triangle_count + hit.triangle) + k].vector;
  }
  corners_.weights = float[](1.0 - (hit.u + hit.v), hit.u, hit.v);
  const TrianglePoint point =
      triangle_point(corners_, hit_position(hit, pixel), -ray_direction(pixel));
  return SurfacePoint(point.position, point.normal, point.shadow_origin,
                      corners[3 * hit.triangle].index, point.side < 0.0);
}
