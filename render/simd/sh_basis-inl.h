// The spherical-harmonics basis in SIMD, in float. Included once per instruction set by the files
// that Highway compiles for each.

#if defined(BRUME_SH_BASIS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_SH_BASIS_INL_H
#undef BRUME_SH_BASIS_INL_H
#else
#define BRUME_SH_BASIS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <numbers>
#include <span>

#include "core/math/spherical_harmonics.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// sh_basis() at unit vectors, times a factor per band; function after function, each with as many
// values as vectors at most have.
template <int bands, std::size_t stride, class D, class V = hn::Vec<D>>
HWY_INLINE void FindBasis(D d, V x, V y, V z, std::span<const float> factors,
                          float (&basis)[sh_size(bands)][stride]) {
  static const ShRecurrence recurrence;
  const auto constant = [&](double value)
                            HWY_ATTR { return hn::Set(d, static_cast<float>(value)); };
  V c = constant(1.0);
  V s = hn::Zero(d);
  V first = constant(0.5 * std::numbers::inv_sqrtpi);
  for (int m = 0; m < bands; ++m) {
    const auto column = static_cast<std::size_t>(m);
    if (m > 0) {
      first = hn::Mul(first, constant(recurrence.start[column]));
      const V turned = hn::Sub(hn::Mul(c, x), hn::Mul(s, y));
      s = hn::MulAdd(s, x, hn::Mul(c, y));
      c = turned;
    }
    V q = first;
    V below = hn::Zero(d);
    for (int l = m; l < bands; ++l) {
      const auto row = static_cast<std::size_t>(l);
      if (l > m) {
        const V next =
            hn::Mul(constant(recurrence.up[row][column]),
                    hn::NegMulAdd(constant(recurrence.down[row][column]), below, hn::Mul(z, q)));
        below = q;
        q = next;
      }
      const V weighted = hn::Mul(q, hn::Set(d, factors[row]));
      hn::Store(hn::Mul(weighted, c), d, basis[sh_index(l, m)]);
      if (m > 0) hn::Store(hn::Mul(weighted, s), d, basis[sh_index(l, -m)]);
    }
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
