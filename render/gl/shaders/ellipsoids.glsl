// The ellipsoids among Gaussians, where ELLIPSOIDS is defined: Ellipsoid of core/transport.
#include "formulas.glsl"

// Half the depth of a line through the center of a Gaussian, or of an ellipsoid, whose a and
// scale are those of its greatest radius.
float half_depth_of(LineProfile line, float scale, float a) {
#ifdef ELLIPSOIDS
  return scale * (a / line.a);
#else
  return scale;
#endif
}

#ifdef ELLIPSOIDS
// Two texels of each: xx yy zz yz, and xz xy of its warp, its least stretch, and whether it is one.
layout(rgba32f, binding = 7) readonly uniform image2D ellipsoids;

struct EllipsoidWarp {
  vec4 first, second;
};

EllipsoidWarp ellipsoid_of(uint i) {
  const ivec2 at = ivec2(2u * i % uint(optics_width), 2u * i / uint(optics_width));
  return EllipsoidWarp(imageLoad(ellipsoids, at), imageLoad(ellipsoids, at + ivec2(1, 0)));
}

bool is_ellipsoid(EllipsoidWarp e) { return e.second.w > 0.0; }

mat3 warp_of(EllipsoidWarp e) {
  return mat3(e.first.x, e.second.y, e.second.x,  //
              e.second.y, e.first.y, e.first.w,   //
              e.second.x, e.first.w, e.first.z);
}

// line_profile() of what may be an ellipsoid.
LineProfile line_profile(EllipsoidWarp e, vec3 b, vec3 w, float a) {
  if (!is_ellipsoid(e)) return line_profile(b, w, a);
  const mat3 warp = warp_of(e);
  return warped_line_profile(warp * b, warp * w, a);
}

// Its length along a vector is how far it reaches along that, over its greatest radius. In double
// precision: the determinant of a thin disc's warp cancels.
dmat3 unwarp_of(EllipsoidWarp e) { return inverse(dmat3(warp_of(e))); }

// The warp is known in single precision: the reach of thin ones to this factor.
const double warp_room = 1.005LF;

// How far it reaches along a unit direction, over its greatest radius, or somewhat farther.
float reach_along(EllipsoidWarp e, vec3 w) {
  return float(warp_room * length(unwarp_of(e) * dvec3(w)));
}
#endif
