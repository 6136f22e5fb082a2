// View rays displaced by noise: RayNoise of core/scene/ray_noise.h.

// noise_lattice::hash().
FORMULA_OF(Bits) Bits lattice_hash(Bits x) {
  const Bits y = (x ^ SHIFT_RIGHT(x, hash_shifts[0])) * hash_factors[0];
  const Bits z = (y ^ SHIFT_RIGHT(y, hash_shifts[1])) * hash_factors[1];
  return z ^ SHIFT_RIGHT(z, hash_shifts[2]);
}

// One axis of the lattice cell that a point lies in: the numbers of its two nodes, and how they
// weigh there.
FORMULA_STRUCT LatticeAxis {
  BITS node[2];
  Real weight[2];
  Real slope[2];
  Real offset[2];
};

FORMULA OF(LatticeAxis) lattice_axis(Real cell) {
  const Real low = floor(cell);
  const Real f = cell - low;
  const Real f2 = f * f;
  const BITS number = TO_BITS(low);
  OF(LatticeAxis) axis;
  axis.node[0] = number & noise_last_node;
  axis.node[1] = (number + 1u) & noise_last_node;
  axis.offset[0] = f;
  axis.offset[1] = f - 1.0;
  // Perlin's fifth order, and its derivative.
  axis.weight[1] = f2 * f * mul_add(mul_add(6.0, f, -15.0), f, 10.0);
  axis.weight[0] = 1.0 - axis.weight[1];
  axis.slope[1] = 30.0 * f2 * (axis.offset[1] * axis.offset[1]);
  axis.slope[0] = -axis.slope[1];
  return axis;
}

// The gradient of w . A at a place in the lattice, per cell.
FORMULA Vec3 potential_gradient(Vec3 cell, Vec3 w, BITS key) {
  const OF(LatticeAxis) x = lattice_axis(cell.x);
  const OF(LatticeAxis) y = lattice_axis(cell.y);
  const OF(LatticeAxis) z = lattice_axis(cell.z);
  Vec3 sum = Vec3(REAL(0.0), REAL(0.0), REAL(0.0));
  for (int corner_ = 0; corner_ < 8; ++corner_) {
    const int i = corner_ & 1;
    const int j = (corner_ >> 1) & 1;
    const int k = corner_ >> 2;
    const BITS bits = lattice_hash(x.node[i] ^ SHIFT_LEFT(y.node[j], noise_axis_bits) ^
                                   SHIFT_LEFT(z.node[k], 2 * noise_axis_bits) ^ key);
    const Vec3 gradient =
        Vec3(flip_sign(w.x, bits) + flip_sign(w.y, SHIFT_LEFT(bits, 3)) +
                 flip_sign(w.z, SHIFT_LEFT(bits, 6)),
             flip_sign(w.x, SHIFT_LEFT(bits, 1)) + flip_sign(w.y, SHIFT_LEFT(bits, 4)) +
                 flip_sign(w.z, SHIFT_LEFT(bits, 7)),
             flip_sign(w.x, SHIFT_LEFT(bits, 2)) + flip_sign(w.y, SHIFT_LEFT(bits, 5)) +
                 flip_sign(w.z, SHIFT_LEFT(bits, 8)));
    const Real height = dot(gradient, Vec3(x.offset[i], y.offset[j], z.offset[k]));
    const Real yz = y.weight[j] * z.weight[k];
    const Real hx = height * x.weight[i];
    sum = mul_add(x.weight[i] * yz, gradient, sum);
    sum =
        Vec3(mul_add(height * x.slope[i], yz, sum.x), mul_add(hx * y.slope[j], z.weight[k], sum.y),
             mul_add(hx * z.slope[k], y.weight[j], sum.z));
  }
  return sum;
}

// LineProfile's e of a Gaussian that the displaced ray passes where the gradient is g; p: its
// center, as warped, from there.
FORMULA Real displaced_e(Vec3 p, Vec3 w, Vec3 g, Real a, Uniform amplitude) {
  const Vec3 offset = mul_add(amplitude, cross(g, w), a * p);
  return dot(offset, offset);
}
