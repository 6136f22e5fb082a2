// Rays bent by noise in SIMD, in float: RayNoise::shift() of core/scene/ray_noise.h. Included once
// per instruction set by the files that Highway compiles for each.

#if defined(BRUME_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_NOISE_INL_H
#undef BRUME_NOISE_INL_H
#else
#define BRUME_NOISE_INL_H
#endif

#include <bit>

#include "render/simd/gaussian-inl.h"
#include "render/simd/gaussian_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// One axis of the lattice cell that a point lies in: its two nodes, kShift bits up in the number
// that noise_lattice::node() makes of three.
template <int kShift, class D, class V = hn::Vec<D>>
struct LatticeAxis {
  using DU = hn::RebindToUnsigned<D>;
  hn::Vec<DU> node[2];
  V weight[2], slope[2], offset[2];

  HWY_INLINE LatticeAxis(D d, V cell) {
    const DU du;
    const hn::RebindToSigned<D> di;
    const V one = hn::Set(d, 1.0f);
    const V floor = hn::Floor(cell);
    const V f = hn::Sub(cell, floor);
    const auto last = hn::Set(du, RayNoise::period - 1);
    const auto number = hn::BitCast(du, hn::ConvertTo(di, floor));
    node[0] = hn::ShiftLeft<kShift>(hn::And(number, last));
    node[1] = hn::ShiftLeft<kShift>(hn::And(hn::Add(number, hn::Set(du, 1)), last));
    const V square = hn::Mul(f, f);
    weight[1] = hn::Mul(hn::Mul(square, f), Horner(d, f, noise_lattice::fade));
    weight[0] = hn::Sub(one, weight[1]);
    offset[0] = f;
    offset[1] = hn::Sub(f, one);
    slope[1] = hn::Mul(hn::Mul(hn::Set(d, noise_lattice::fade_slope), square),
                       hn::Mul(offset[1], offset[1]));
    slope[0] = hn::Neg(slope[1]);
  }
};

// noise_lattice::hash().
template <class DU, class VU = hn::Vec<DU>>
HWY_INLINE VU LatticeHash(DU du, VU x) {
  using noise_lattice::hash_factors, noise_lattice::hash_shifts;
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<hash_shifts[0]>(x)), hn::Set(du, hash_factors[0]));
  x = hn::Mul(hn::Xor(x, hn::ShiftRight<hash_shifts[1]>(x)), hn::Set(du, hash_factors[1]));
  return hn::Xor(x, hn::ShiftRight<hash_shifts[2]>(x));
}

// The gradient of w . A at the point t w, per cell.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V3<V> PotentialGradient(D d, const BatchNoise& noise, const V3<V>& w, V t) {
  const hn::RebindToUnsigned<D> du;
  constexpr int bits_per_axis = std::countr_zero(static_cast<unsigned>(RayNoise::period));
  // Beyond this float cannot distinguish cells, and larger indices would not fit the nodes' hashes.
  const V max_distance = hn::Set(d, coefficient::max_lattice_distance);
  const V along = hn::Max(hn::Min(hn::Mul(hn::Set(d, noise.frequency), t), max_distance),
                          hn::Neg(max_distance));
  const LatticeAxis<0, D> x(d, hn::MulAdd(along, w.x, hn::Set(d, noise.x)));
  const LatticeAxis<bits_per_axis, D> y(d, hn::MulAdd(along, w.y, hn::Set(d, noise.y)));
  LatticeAxis<2 * bits_per_axis, D> z(d, hn::MulAdd(along, w.z, hn::Set(d, noise.z)));
  for (auto& node : z.node) node = hn::Xor(node, hn::Set(du, noise.key));
  const auto sign = hn::Set(du, 0x80000000U);
  const V zero = hn::Zero(d);
  V3<V> sum{zero, zero, zero};
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1;
    const int j = (corner >> 1) & 1;
    const int k = corner >> 2;
    const auto bits = LatticeHash(du, hn::Xor(hn::Xor(x.node[i], y.node[j]), z.node[k]));
    const auto signed_by = [&](V value, auto shifted) HWY_ATTR {
      return hn::BitCast(d, hn::Xor(hn::BitCast(du, value), hn::And(shifted, sign)));
    };
    const V3<V> gradient{
        hn::Add(hn::Add(signed_by(w.x, bits), signed_by(w.y, hn::ShiftLeft<3>(bits))),
                signed_by(w.z, hn::ShiftLeft<6>(bits))),
        hn::Add(
            hn::Add(signed_by(w.x, hn::ShiftLeft<1>(bits)), signed_by(w.y, hn::ShiftLeft<4>(bits))),
            signed_by(w.z, hn::ShiftLeft<7>(bits))),
        hn::Add(
            hn::Add(signed_by(w.x, hn::ShiftLeft<2>(bits)), signed_by(w.y, hn::ShiftLeft<5>(bits))),
            signed_by(w.z, hn::ShiftLeft<8>(bits)))};
    const V height = dot(gradient, V3<V>{x.offset[i], y.offset[j], z.offset[k]});
    const V yz = hn::Mul(y.weight[j], z.weight[k]);
    const V weight = hn::Mul(x.weight[i], yz);
    const V hx = hn::Mul(height, x.weight[i]);
    sum.x = hn::MulAdd(weight, gradient.x, hn::MulAdd(hn::Mul(height, x.slope[i]), yz, sum.x));
    sum.y = hn::MulAdd(weight, gradient.y, hn::MulAdd(hn::Mul(hx, y.slope[j]), z.weight[k], sum.y));
    sum.z = hn::MulAdd(weight, gradient.z, hn::MulAdd(hn::Mul(hx, z.slope[k]), y.weight[j], sum.z));
  }
  return sum;
}

// LineProfile::e of a Gaussian that the displaced ray passes at t0; p: its center, as warped, from
// there.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V DisplacedDistance(D d, const BatchNoise& noise, const V3<V>& p, const V3<V>& w, V a,
                               V t0) {
  const V3<V> g = PotentialGradient(d, noise, w, t0);
  const V amplitude = hn::Set(d, noise.amplitude);
  // a p - amplitude w x g
  const V x = hn::NegMulAdd(w.z, g.y, hn::Mul(w.y, g.z));
  const V y = hn::NegMulAdd(w.x, g.z, hn::Mul(w.z, g.x));
  const V z = hn::NegMulAdd(w.y, g.x, hn::Mul(w.x, g.y));
  const V3<V> offset{hn::NegMulAdd(amplitude, x, hn::Mul(a, p.x)),
                     hn::NegMulAdd(amplitude, y, hn::Mul(a, p.y)),
                     hn::NegMulAdd(amplitude, z, hn::Mul(a, p.z))};
  return dot(offset, offset);
}

// The warp of an ellipsoid of a batch.
template <class D, class V = hn::Vec<D>>
HWY_INLINE WarpOf<V> BatchWarp(D d, const BatchEllipsoid& e) {
  const auto set = [&](int k) HWY_ATTR { return hn::Set(d, e.warp[static_cast<std::size_t>(k)]); };
  return {set(0), set(1), set(2), set(3), set(4), set(5)};
}

// Gaussian j of a batch as rays of direction w meet it. A kernel for balls does not test for
// ellipsoids, and one without noise not for displaced rays.
template <BatchKind kKind, class D, class V = hn::Vec<D>>
HWY_INLINE LineProfile<D> BatchLineProfile(D d, const GaussianBatch& g, std::size_t j,
                                           const V3<V>& w) {
  const V a = hn::Set(d, g.a[j]);
  if constexpr (kKind == BatchKind::ellipsoids) {
    if (g.is_ellipsoid(j)) {
      const BatchEllipsoid& ellipsoid = g.ellipsoids[j];
      const glm::vec3& center = ellipsoid.center;
      const V3<V> b{hn::Set(d, center.x), hn::Set(d, center.y), hn::Set(d, center.z)};
      const V3<V> v = BatchWarp(d, ellipsoid)(w);
      LineProfile<D> line(d, b, v, a);
      if (g.noise.on() && !hn::AllTrue(d, hn::Gt(line.e, hn::Set(d, g.max_undisplaced_e[j])))) {
        line.e = DisplacedDistance(d, g.noise, minus(b, line.t0, v), w, a, line.t0);
      }
      return line;
    }
  }
  const V3<V> b{hn::Set(d, g.x[j]), hn::Set(d, g.y[j]), hn::Set(d, g.z[j])};
  LineProfile<D> line(b, w, a);
  if (kKind == BatchKind::displaced_balls || (kKind == BatchKind::ellipsoids && g.noise.on())) {
    if (!hn::AllTrue(d, hn::Gt(line.e, hn::Set(d, g.max_undisplaced_e[j])))) {
      line.e = DisplacedDistance(d, g.noise, minus(b, line.t0, w), w, a, line.t0);
    }
  }
  return line;
}

// Half the optical depth of a line through the center of Gaussian j, in the line's direction.
template <BatchKind kKind, class D, class V = hn::Vec<D>>
HWY_INLINE V BatchHalfDepth(D d, const GaussianBatch& g, std::size_t j,
                            const LineProfile<D>& line) {
  if constexpr (kKind == BatchKind::ellipsoids) {
    if (g.is_ellipsoid(j)) return hn::Div(hn::Set(d, g.scale[j] * g.a[j]), line.a);
  }
  return hn::Set(d, g.scale[j]);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_NOISE_INL_H
