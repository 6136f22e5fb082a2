// Where directions lie in maps.

// Where a direction ahead lies in the square around a cone, [-1, 1]^2; `cotangent`: of its angle.
FORMULA Vec2 cone_position(Vec3 q, Uniform cotangent) {
  const Real scale = cotangent / max(q.z, tiny);
  return Vec2(scale * q.x, scale * q.y);
}

// A direction, of any length but 0, unfolded from the octahedron onto [-1, 1]^2.
FORMULA Vec2 octahedral_position(Vec3 q) {
  const Real inverse = 1.0 / max(abs(q.x) + (abs(q.y) + abs(q.z)), tiny);
  const Real x = q.x * inverse;
  const Real y = q.y * inverse;
  const Bool is_below = q.z < 0.0;
  return Vec2(select(is_below, copy_sign(1.0 - abs(y), x), x),
              select(is_below, copy_sign(1.0 - abs(x), y), y));
}
