// The line integral of a Gaussian in SIMD, included once per instruction set by kernels.cpp.

#if defined(BRUME_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_KERNELS_INL_H
#undef BRUME_KERNELS_INL_H
#else
#define BRUME_KERNELS_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}

struct V3 {
  V x, y, z;
};
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
// a - s b
HWY_INLINE V3 minus(const V3& a, V s, const V3& b) {
  return {hn::NegMulAdd(s, b.x, a.x), hn::NegMulAdd(s, b.y, a.y), hn::NegMulAdd(s, b.z, a.z)};
}

// erfcx(x) = exp(x^2) erfc(x) for x >= 0: relative error 3e-7 up to 20, 4e-6 beyond, where every
// use multiplies it by exp(-400) or less.
HWY_INLINE V Erfcx(V x) {
  const V t = hn::Div(set(1.0f), hn::MulAdd(set(0.5f), x, set(1.0f)));
  V p = set(-0.0569184758f);
  p = hn::MulAdd(p, t, set(0.2754870355f));
  p = hn::MulAdd(p, t, set(-0.4712418020f));
  p = hn::MulAdd(p, t, set(0.2629913824f));
  p = hn::MulAdd(p, t, set(-0.0183402074f));
  p = hn::MulAdd(p, t, set(0.2000166923f));
  p = hn::MulAdd(p, t, set(0.2435849011f));
  p = hn::MulAdd(p, t, set(0.2823328376f));
  p = hn::MulAdd(p, t, set(0.2820876837f));
  return hn::Mul(p, t);
}

// erf(x) for |x| <= 1, relative error 2e-7.
HWY_INLINE V ErfSmall(V x) {
  const V x2 = hn::Mul(x, x);
  V p = set(-0.00056314253f);
  p = hn::MulAdd(p, x2, set(0.0049175541f));
  p = hn::MulAdd(p, x2, set(-0.0267113168f));
  p = hn::MulAdd(p, x2, set(0.1128018051f));
  p = hn::MulAdd(p, x2, set(-0.3761232495f));
  p = hn::MulAdd(p, x2, set(1.1283791065f));
  return hn::Mul(p, x);
}

// exp(-e) erfc(|u|), in one exponent.
HWY_INLINE V ScaledErfc(V e, V u) {
  return hn::Mul(hn::Exp(D(), hn::Neg(hn::MulAdd(u, u, e))), Erfcx(hn::Abs(u)));
}

// exp(-e) (erf(u1) - erf(u0)) for u0 <= u1 with relative accuracy also in the tails and for short
// segments; k = u1 - u0, computed without cancellation by the caller.
HWY_INLINE V SegmentIntegral(V e, V u0, V u1, V k) {
  const D d;
  const V zero = hn::Zero(d);
  const V abs0 = hn::Abs(u0);
  const V abs1 = hn::Abs(u1);
  const M straddles = hn::And(hn::Le(u0, zero), hn::Ge(u1, zero));
  const V whole = hn::Exp(d, hn::Neg(e));

  // Ends beyond 4 across the centre, the common case: nothing is missing from a whole line.
  const V far = set(4.0f);
  if (hn::AllTrue(d, hn::And(straddles, hn::Gt(hn::Min(abs0, abs1), far)))) {
    return hn::Add(whole, whole);
  }
  const V first = ScaledErfc(e, u0);
  const V second = ScaledErfc(e, u1);
  const V across = hn::Sub(hn::Sub(hn::Add(whole, whole), first), second);
  V sum = hn::IfThenElse(straddles, across, hn::Abs(hn::Sub(first, second)));

  const V reach = hn::Add(set(1.0f), hn::Add(abs0, abs1));
  const M is_short = hn::Lt(hn::Mul(k, reach), set(1.0f));
  if (!hn::AllFalse(d, is_short)) {
    // Four Gauss-Legendre points as two pairs: exp(-(m - s)^2) + exp(-(m + s)^2).
    const V m = hn::Mul(set(0.5f), hn::Add(u0, u1));
    const auto pair = [&](float node) HWY_ATTR {
      const V s = hn::Mul(set(0.5f * node), k);
      const V low = hn::Sub(m, s);
      const V high = hn::Add(m, s);
      return hn::Add(hn::Exp(d, hn::Neg(hn::MulAdd(low, low, e))),
                     hn::Exp(d, hn::Neg(hn::MulAdd(high, high, e))));
    };
    // (2 / sqrt(pi)) times the mean of the integrand times k.
    const V mean = hn::MulAdd(set(0.6521451548625461f), pair(0.3399810435848563f),
                              hn::Mul(set(0.3478548451374538f), pair(0.8611363115940526f)));
    const V value = hn::Mul(set(0.5641895835477563f), hn::Mul(k, mean));
    sum = hn::IfThenElse(is_short, value, sum);
  }
  return sum;
}

// A Gaussian as a ray from the origin of `b` sees it.
struct Crossing {
  V t0;  // [u]
  V e;   // a^2 h^2
  V3 p;  // b - t0 w

  HWY_INLINE Crossing(const V3& b, const V3& w, V a) : t0(dot(b, w)), p(minus(b, t0, w)) {
    const V3 q{hn::Mul(a, p.x), hn::Mul(a, p.y), hn::Mul(a, p.z)};
    e = dot(q, q);
  }

  // Depth over [0, length] in units of `scale`.
  HWY_INLINE V Depth(V a, V length) const {
    const V u0 = hn::Neg(hn::Mul(a, t0));
    const V u1 = hn::Mul(a, hn::Sub(length, t0));
    return SegmentIntegral(e, u0, u1, hn::Mul(a, length));
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_KERNELS_INL_H
