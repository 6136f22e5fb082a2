// Light at surfaces.

// Irradiance of a surface by light around a point light, of which the bands 0, 1, 2 and 4 are of
// these strengths: convolved with clamped_cosine_sh(), written out. The other bands vanish.
FORMULA Real band_irradiance(Real cosine, Real band_0, Real band_1, Real band_2, Real band_4) {
  const Real x2 = cosine * cosine;
  const Real legendre_2 = mul_add(1.5, x2, -0.5);
  const Real legendre_4 = mul_add(mul_add(4.375, x2, -3.75), x2, 0.375);
  Real sum = 0.25 * band_0;
  sum = mul_add(0.5 * cosine, band_1, sum);
  sum = mul_add(0.3125 * legendre_2, band_2, sum);
  return mul_add(-0.09375 * legendre_4, band_4, sum);
}

// Where an optical depth lies in [-1, 1], in which the polynomials of a ScatterTable are.
FORMULA Real scatter_position(Real depth) {
  const Real root = sqrt(depth);
  return scatter_scale * (root / (root + 1.0)) - 1.0;
}

// Phong's lobe: `cosine` is that of the angle to the mirrored direction, above 0.
FORMULA Real phong_lobe(Real cosine, Real exponent) {
  return exp(exponent * log(clamp(cosine, tiny, 1.0)));
}

// Unit, or 0 where v is too short.
FORMULA Vec3 unit_or_none(Vec3 v) {
  const Real square = dot(v, v);
  return where(square > tiny_square, 1.0 / sqrt(max(square, tiny_square))) * v;
}

// A triangle at a point: weights of the corners there.
FORMULA_STRUCT CornersAtPoint {
  Vec3 positions[3];
  Vec3 normals[3];  // any length
  Real weights[3];
};

FORMULA_STRUCT TrianglePoint {
  Vec3 position;       // on the triangle
  Vec3 normal;         // on the eye's side; 0 where neither triangle nor mesh has one
  Vec3 shadow_origin;  // where shadow rays start
  Real side;           // -1: the back of the mesh is seen, by its normals, else 1
};

// The point of a triangle at `near_it`.
FORMULA OF(TrianglePoint) triangle_point(OF(CornersAtPoint) corners, Vec3 near_it, Vec3 to_eye) {
  const Vec3 origin = corners.positions[0];
  // Lengthened first: the product of two short edges would vanish.
  Vec3 geometric = unit_or_none(cross(unit_or_none(corners.positions[1] - origin),
                                      unit_or_none(corners.positions[2] - origin)));
  Vec3 sum = corners.weights[0] * corners.normals[0];
  sum = mul_add(corners.weights[1], corners.normals[1], sum);
  sum = mul_add(corners.weights[2], corners.normals[2], sum);
  const Vec3 smooth_ = unit_or_none(sum);
  OF(TrianglePoint) point;
  point.normal = select(dot(smooth_, smooth_) > 0.0, smooth_, geometric);
  geometric = copy_sign(REAL(1.0), dot(geometric, to_eye)) * geometric;
  point.side = select(dot(point.normal, geometric) < 0.0, REAL(-1.0), REAL(1.0));
  point.normal = point.side * point.normal;
  point.position = mul_add(-dot(near_it - origin, geometric), geometric, near_it);
  // off_plane_rounding()
  const Vec3 sizes = max(abs(origin), max(abs(corners.positions[1]), abs(corners.positions[2])));
  const Real rounding = REAL(position_rounding);
  const Real off_plane =
      rounding * mul_add(rounding, max(sizes.x, max(sizes.y, sizes.z)), dot(abs(geometric), sizes));
  point.shadow_origin = mul_add(off_plane, geometric, point.position);
  for (int k = 0; k < 3; ++k) {
    // How far the point lies below the tangent plane of a corner.
    const Vec3 n = point.side * corners.normals[k];
    const Real below = min(dot(point.position - corners.positions[k], n), 0.0);
    point.shadow_origin = mul_add(-(corners.weights[k] * below), n, point.shadow_origin);
  }
  return point;
}
