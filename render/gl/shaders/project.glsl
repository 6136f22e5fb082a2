// Every Gaussian as the eye sees it, and the tiles that its cutoff sphere may touch: CameraRays::bounds()
// and Tiles::lists().
#include "linear.glsl"
#include "constants.glsl"
#include "structs.glsl"
#include "ellipsoids.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) restrict readonly buffer Centers { double centers[]; };  // x y z of each
layout(std430, binding = 1) restrict readonly buffer Shapes { GaussianShape shapes[]; };
layout(std430, binding = 2) restrict writeonly buffer Seen { SeenGaussian seen[]; };
// [x0, x1) x [y0, y1) in tiles: x0 + y0 << 16, x1 + y1 << 16.
layout(std430, binding = 3) restrict writeonly buffer Rectangles { uvec2 rectangles[]; };
layout(std430, binding = 4) restrict buffer Totals { TileTotals totals; };

uniform uint count;
uniform dvec3 eye;
uniform dvec3 forward;
uniform dvec3 right;
uniform dvec3 up;
uniform double half_width;  // of the whole film at distance 1
uniform double half_height;
uniform ivec2 whole_film;
uniform ivec2 surround;        // a film around the axis that holds the whole one
uniform dvec3 whole_start;     // where that begins on it, x and y
uniform ivec2 whole_tiles;     // of the whole film
uniform ivec2 first_tile;      // of this one
uniform ivec2 tiles;           // as many
uniform int scale;
uniform float farther;  // how far noise bends rays, in radii

#ifdef PARALLEL
// The stretch of one film axis, from -1 to 1, that a disc around (x, z) covers as seen along z;
// (1, -1): none.
dvec2 covered(double x, double z, double radius, double half_size) {
  if (z <= -radius) return dvec2(1.0LF, -1.0LF);
  return dvec2(max(-1.0LF, (x - radius) / half_size), min(1.0LF, (x + radius) / half_size));
}

#ifdef ELLIPSOIDS
// The same of an ellipse; `squares` holds the products xx, xz and zz of its reaches along x and z.
dvec2 covered(double x, double z, double radius, dvec3 squares, double half_size) {
  if (z <= -sqrt(squares.z)) return dvec2(1.0LF, -1.0LF);
  const double reach = sqrt(squares.x);
  return dvec2(max(-1.0LF, (x - reach) / half_size), min(1.0LF, (x + reach) / half_size));
}
#endif
#else
// The stretch of one film axis, from -1 to 1, that a disc around (x, z) covers as seen from the
// origin along z; (1, -1): none. By the tangents, whose angles are those of (x, z) plus and minus
// asin(radius / distance).
dvec2 covered(double x, double z, double radius, double half_size) {
  const double square = x * x + z * z - radius * radius;
  if (square <= 0.0LF) return dvec2(-1.0LF, 1.0LF);
  const double s = sqrt(square);
  const dvec2 low = dvec2(x * s - z * radius, z * s + x * radius);
  const dvec2 high = dvec2(x * s + z * radius, z * s - x * radius);
  if (low.y <= 0.0LF && x >= 0.0LF) return dvec2(1.0LF, -1.0LF);
  if (high.y <= 0.0LF && x < 0.0LF) return dvec2(1.0LF, -1.0LF);
  // A tangent along the film's plane is beyond all of it.
  return dvec2(low.y <= 0.0LF ? -1.0LF : max(-1.0LF, low.x / (low.y * half_size)),
               high.y <= 0.0LF ? 1.0LF : min(1.0LF, high.x / (high.y * half_size)));
}

#ifdef ELLIPSOIDS
// The same of an ellipse; `squares` holds the products xx, xz and zz of its reaches along x and z.
dvec2 covered(double x, double z, double radius, dvec3 squares, double half_size) {
  const double front = z * z - squares.z;
  // In part behind the eye: as the disc around it.
  if (z <= 0.0LF || front <= 0.0LF) return covered(x, z, radius, half_size);
  const double middle = x * z - squares.y;
  const double root = sqrt(max(middle * middle - front * (x * x - squares.x), 0.0LF));
  return dvec2(max(-1.0LF, (middle - root) / (front * half_size)),
               min(1.0LF, (middle + root) / (front * half_size)));
}
#endif
#endif

int first_pixel(double s, int size, double start) {
  return int(ceil(0.5LF * (s + 1.0LF) * double(size) - 0.5LF - pixel_rounding - start));
}

int end_pixel(double s, int size, double start) {
  return int(floor(0.5LF * (s + 1.0LF) * double(size) - 0.5LF + pixel_rounding - start)) + 1;
}

void main() {
  const uint i = linear_group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  if (i >= count) return;
  const dvec3 q = dvec3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]) - eye;
  const GaussianShape shape = shapes[i];
  const float displaced = sqrt(shape.max_e) + farther;
  seen[i] = SeenGaussian(vec3(q), shape.a, shape.scale, shape.max_e, displaced * displaced,
                         shape.cutoff_radius);
  rectangles[i] = uvec2(0u);
  if (!(shape.cutoff_radius > 0.0)) return;

  const double radius = double(shape.cutoff_radius) + double(farther) / double(shape.a);
  const double z = dot(q, forward);
  dvec2 u = covered(dot(q, right), z, radius, half_width);
  dvec2 v = covered(-dot(q, up), z, radius, half_height);
#ifdef ELLIPSOIDS
  const EllipsoidWarp e = ellipsoid_of(i);
  if (is_ellipsoid(e)) {
    const dmat3 reaches = radius * warp_room * unwarp_of(e);
    const dvec3 along_x = reaches * right;
    const dvec3 along_y = reaches * -up;
    const dvec3 along_z = reaches * forward;
    const double zz = dot(along_z, along_z);
    u = covered(dot(q, right), z, radius, dvec3(dot(along_x, along_x), dot(along_x, along_z), zz),
                half_width);
    v = covered(-dot(q, up), z, radius, dvec3(dot(along_y, along_y), dot(along_y, along_z), zz),
                half_height);
  }
#endif
  if (!(u.x < u.y) || !(v.x < v.y)) return;
  const ivec2 first = ivec2(first_pixel(u.x, surround.x, whole_start.x),
                            first_pixel(v.x, surround.y, whole_start.y));
  const ivec2 last = ivec2(end_pixel(u.y, surround.x, whole_start.x),
                           end_pixel(v.y, surround.y, whole_start.y));
  const ivec2 low = max(first, ivec2(0));
  const ivec2 high = min(last, whole_film);
  if (any(greaterThanEqual(low, high))) return;
  // A ray of the last column or row may lie slightly before its grid position.
  const ivec2 tile = ivec2(tile_width, tile_height);
  const ivec2 begin = max(low / scale / tile - first_tile, ivec2(0));
  const ivec2 end =
      min(min((high + scale - 2) / scale / tile + 1, whole_tiles) - first_tile, tiles);
  if (any(greaterThanEqual(begin, end))) return;
  rectangles[i] = uvec2(begin.x | begin.y << 16, end.x | end.y << 16);
  const uint area = uint((end.x - begin.x) * (end.y - begin.y));
  atomicAdd(totals.used, 1u);
  atomicAdd(totals.coarse, (area + coarse_entries - 1u) / coarse_entries);
}
