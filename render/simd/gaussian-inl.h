// The line integral of a Gaussian in SIMD, in float and in double. Included once per instruction
// set by the files that Highway compiles for each.

#if defined(BRUME_GAUSSIAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_GAUSSIAN_INL_H
#undef BRUME_GAUSSIAN_INL_H
#else
#define BRUME_GAUSSIAN_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <numbers>

#include "render/simd/coefficients.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct V3 {
  V x, y, z;
};
template <class V>
HWY_INLINE V dot(const V3<V>& a, const V3<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
// a - s b
template <class V>
HWY_INLINE V3<V> minus(const V3<V>& a, V s, const V3<V>& b) {
  return {hn::NegMulAdd(s, b.x, a.x), hn::NegMulAdd(s, b.y, a.y), hn::NegMulAdd(s, b.z, a.z)};
}

// A polynomial, highest coefficient first.
template <class D, class V, class T, std::size_t n>
HWY_INLINE V Horner(D d, V x, const T (&coefficient)[n]) {
  V p = hn::Set(d, coefficient[0]);
  for (std::size_t i = 1; i < n; ++i) p = hn::MulAdd(p, x, hn::Set(d, coefficient[i]));
  return p;
}

// erfcx(x) = exp(x^2) erfc(x) for x >= 0. Float: relative error 3e-7 up to 20, 4e-6 beyond, where
// every use multiplies it by exp(-400) or less. Double: 1e-15.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V Erfcx(D d, V x) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    const V one = hn::Set(d, 1.0f);
    const V t = hn::Div(one, hn::MulAdd(hn::Set(d, 0.5f), x, one));
    return hn::Mul(t, Horner(d, t, coefficient::erfcx));
  } else {
    // (1 + 2 x) erfcx(x) as a polynomial in (x - 3.75) / (x + 3.75) (Shepherd and Laframboise
    // 1981 chose the variable; the coefficients are a Chebyshev fit in 40 digits).
    constexpr double coefficients[] = {
        -2.623107347133476e-09, -1.9551358868985616e-09, 3.197926671666804e-08,
        1.879082322370048e-08,  -2.4857126248016745e-07, -5.084465378687302e-08,
        1.7419821586224816e-06, -9.792625707303523e-07,  -1.1438048033346894e-05,
        2.2387565714911816e-05, 5.164652974177416e-05,   -0.00029015535246077655,
        0.000293714378044958,   0.0017556261651970652,   -0.009746579683265262,
        0.02836227737211114,    -0.05869339857664934,    0.09230432116428125,
        -0.10880393014244462,   0.08227673848999506,     0.0035854154854790257,
        -0.14024059858554525,   1.2375126308378275};
    // Past 1e150 nothing is left of erfc, and the quotient would be inf / inf.
    const V y = hn::Min(x, hn::Set(d, 1e150));
    const V center = hn::Set(d, 3.75);
    const V t = hn::Div(hn::Sub(y, center), hn::Add(y, center));
    return hn::Div(Horner(d, t, coefficients), hn::MulAdd(hn::Set(d, 2.0), y, hn::Set(d, 1.0)));
  }
}

// exp(-e) erfc(|u|), in one exponent.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V ScaledErfc(D d, V e, V u) {
  return hn::Mul(hn::Exp(d, hn::Neg(hn::MulAdd(u, u, e))), Erfcx(d, hn::Abs(u)));
}

// exp(-e) (erf(u1) - erf(u0)) for u0 <= u1 with relative accuracy also in the tails and for short
// segments; k = u1 - u0, computed without cancellation by the caller.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SegmentIntegral(D d, V e, V u0, V u1, V k) {
  using T = hn::TFromD<D>;
  constexpr bool is_float = sizeof(T) == 4;
  const V zero = hn::Zero(d);
  const V abs0 = hn::Abs(u0);
  const V abs1 = hn::Abs(u1);
  const auto straddles = hn::And(hn::Le(u0, zero), hn::Ge(u1, zero));
  const V full_line_half = hn::Exp(d, hn::Neg(e));

  // Both ends far from the center, the common case: the integral of the full line.
  const V far = hn::Set(d, is_float ? T(4) : T(6));
  if (hn::AllTrue(d, hn::And(straddles, hn::Gt(hn::Min(abs0, abs1), far)))) {
    return hn::Add(full_line_half, full_line_half);
  }
  const V first = ScaledErfc(d, e, u0);
  const V second = ScaledErfc(d, e, u1);
  const V across = hn::Sub(hn::Sub(hn::Add(full_line_half, full_line_half), first), second);
  V sum = hn::IfThenElse(straddles, across, hn::Abs(hn::Sub(first, second)));

  const V steepness = hn::Add(hn::Set(d, T(1)), hn::Add(abs0, abs1));
  const auto is_short = hn::Lt(hn::Mul(k, steepness), hn::Set(d, T(1)));
  if (!hn::AllFalse(d, is_short)) {
    // Gauss-Legendre points as pairs, exp(-(m - s)^2) + exp(-(m + s)^2): four in float, six in
    // double.
    const V m = hn::Mul(hn::Set(d, T(0.5)), hn::Add(u0, u1));
    const auto pair = [&](double node, double weight) HWY_ATTR {
      const V s = hn::Mul(hn::Set(d, T(0.5 * node)), k);
      const V low = hn::Sub(m, s);
      const V high = hn::Add(m, s);
      return hn::Mul(hn::Set(d, T(weight)),
                     hn::Add(hn::Exp(d, hn::Neg(hn::MulAdd(low, low, e))),
                             hn::Exp(d, hn::Neg(hn::MulAdd(high, high, e)))));
    };
    V mean;
    if constexpr (is_float) {
      using coefficient::gauss_nodes, coefficient::gauss_weights;
      mean =
          hn::Add(pair(gauss_nodes[0], gauss_weights[0]), pair(gauss_nodes[1], gauss_weights[1]));
    } else {
      mean = hn::Add(hn::Add(pair(0.2386191860831969086, 0.4679139345726910474),
                             pair(0.6612093864662645137, 0.3607615730481386076)),
                     pair(0.9324695142031520278, 0.1713244923791703450));
    }
    const V value = hn::Mul(hn::Set(d, T(std::numbers::inv_sqrtpi)), hn::Mul(k, mean));
    sum = hn::IfThenElse(is_short, value, sum);
  }
  return sum;
}

// The cosine of the angle by which light turns towards the eye at a point that is `along` past the
// light on the ray and `distance` from it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V CosTheta(D d, V along, V distance) {
  const V min_distance = hn::Set(d, hn::TFromD<D>(coefficient::tiny));
  return hn::Neg(hn::Div(along, hn::Max(distance, min_distance)));
}

// See henyey_greenstein() in core/transport/phase_function.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V HenyeyGreenstein(D d, V cos_theta, hn::TFromD<D> g) {
  const V s = hn::NegMulAdd(hn::Set(d, 2 * g), cos_theta, hn::Set(d, 1 + g * g));
  return hn::Div(hn::Set(d, 1 - g * g), hn::Mul(s, hn::Sqrt(s)));
}

// A symmetric matrix: Ellipsoid::warp.
template <class V>
struct WarpOf {
  V xx, yy, zz, yz, xz, xy;

  HWY_INLINE V3<V> operator()(const V3<V>& v) const {
    return {hn::MulAdd(xx, v.x, hn::MulAdd(xy, v.y, hn::Mul(xz, v.z))),
            hn::MulAdd(xy, v.x, hn::MulAdd(yy, v.y, hn::Mul(yz, v.z))),
            hn::MulAdd(xz, v.x, hn::MulAdd(yz, v.y, hn::Mul(zz, v.z)))};
  }
};

// A Gaussian of center b relative to a line through the origin: brume::LineProfile for vectors.
template <class D, class V = hn::Vec<D>>
struct LineProfile {
  V t0;  // [u]
  V e;   // a^2 h^2
  V a;   // [1/u]

  HWY_INLINE LineProfile(const V3<V>& b, const V3<V>& w, V a_) : t0(dot(b, w)), a(a_) {
    const V3<V> p = minus(b, t0, w);
    const V3<V> q{hn::Mul(a, p.x), hn::Mul(a, p.y), hn::Mul(a, p.z)};
    e = dot(q, q);
  }
  // Of an ellipsoid: b and w warped, a that of its greatest radius.
  HWY_INLINE LineProfile(D d, const V3<V>& b, const V3<V>& w, V greatest_a) {
    const V speed2 = dot(w, w);
    const V inverse = hn::Div(hn::Set(d, hn::TFromD<D>(1)), speed2);
    t0 = hn::Mul(dot(b, w), inverse);
    const V3<V> p = minus(b, t0, w);
    e = hn::Mul(hn::Mul(greatest_a, greatest_a), dot(p, p));
    a = hn::Mul(greatest_a, hn::Sqrt(speed2));
  }

  // Optical depth over [0, length] in units of c sqrt(pi) / (2 a).
  HWY_INLINE V UnitDepth(D d, V length) const {
    const V u0 = hn::Neg(hn::Mul(a, t0));
    const V u1 = hn::Mul(a, hn::Sub(length, t0));
    return SegmentIntegral(d, e, u0, u1, hn::Mul(a, length));
  }

  // The mean parameter of the Gaussian on [0, length], in that interval; `unit_depth` is
  // UnitDepth()'s. Float only. Absolute error 1e-5 / a, or 1e-3 of a short segment.
  HWY_INLINE V Mean(D d, V length, V unit_depth) const {
    const V u0 = hn::Neg(hn::Mul(a, t0));
    const V u1 = hn::Mul(a, hn::Sub(length, t0));
    const V k = hn::Mul(a, length);
    const V first = hn::Exp(d, hn::Neg(hn::MulAdd(u0, u0, e)));
    const V second = hn::Exp(d, hn::Neg(hn::MulAdd(u1, u1, e)));
    const V integral =
        hn::Max(hn::Mul(hn::Set(d, static_cast<float>(coefficient::sqrt_pi)), unit_depth),
                hn::Set(d, coefficient::tiny_square));
    const V mean = hn::Add(t0, hn::Div(hn::Div(hn::Sub(first, second), integral), a));
    // That cancels on a short segment: from its middle, by the density's slope there.
    const V m = hn::Mul(hn::Set(d, 0.5f), hn::Add(u0, u1));
    const V steepness = hn::Add(hn::Set(d, 1.0f), hn::Add(hn::Abs(u0), hn::Abs(u1)));
    const V k2 = hn::Mul(k, k);
    const V second_order = hn::MulAdd(hn::Mul(m, m), k2, k2);
    const V shift = hn::Mul(hn::Mul(m, hn::Mul(k, length)),
                            hn::NegMulAdd(second_order, hn::Set(d, coefficient::mean_shift[1]),
                                          hn::Set(d, coefficient::mean_shift[0])));
    const V near_center = hn::Sub(hn::Mul(hn::Set(d, 0.5f), length), shift);
    const auto is_short = hn::Lt(hn::Mul(k, steepness), hn::Set(d, 1.0f));
    // Where everything underflows the quotient is meaningless; the mean of half a Gaussian is
    // within 1 / a.
    const V zero = hn::Zero(d);
    const V max_t = hn::Add(hn::Max(t0, zero), hn::Div(hn::Set(d, 1.0f), a));
    const V t = hn::Min(hn::IfThenElse(is_short, near_center, mean), hn::Min(max_t, length));
    return hn::Max(t, zero);
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_GAUSSIAN_INL_H
