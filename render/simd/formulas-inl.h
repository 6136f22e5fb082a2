// The formulas of render/formulas for Highway's vectors; shaders/formulas.glsl has them for
// shaders. Included once per instruction set by the files that Highway compiles for each.

#if defined(BRUME_FORMULAS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_FORMULAS_INL_H
#undef BRUME_FORMULAS_INL_H
#else
#define BRUME_FORMULAS_INL_H
#endif

#include <bit>

#include "core/scene/ray_noise.h"
#include "render/geometry/ray_range.h"
#include "render/geometry/rounding.h"
#include "render/simd/coefficients.h"
#include "render/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using namespace coefficient;
using noise_lattice::hash_factors, noise_lattice::hash_shifts;
inline constexpr std::uint32_t noise_last_node = RayNoise::period - 1;
inline constexpr int noise_axis_bits = std::countr_zero(std::uint32_t{RayNoise::period});

template <class V>
using UnsignedOf = hn::VFromD<hn::RebindToUnsigned<hn::DFromV<V>>>;

// The types that formulas are written in: Real is a vector of lanes, Uniform a number that is the
// same in all.
#define CONSTANT inline constexpr double
#define FORMULA_OF(Type) \
  template <class Type>  \
  HWY_INLINE
#define FORMULA FORMULA_OF(Real)
#define FORMULA_STRUCT  \
  template <class Real> \
  struct
#define OF(Struct) Struct<Real>
#define Uniform hn::TFromV<Real>
#define Vec2 V2<Real>
#define Vec3 V3<Real>
#define Bool auto
#define REAL(x) lanes<Real>(x)
#define BITS UnsignedOf<Real>
#define TO_BITS(x)                                      \
  hn::BitCast(hn::RebindToUnsigned<hn::DFromV<Real>>(), \
              hn::ConvertTo(hn::RebindToSigned<hn::DFromV<Real>>(), x))
#define SHIFT_LEFT(x, n) hn::ShiftLeft<n>(x)
#define SHIFT_RIGHT(x, n) hn::ShiftRight<n>(x)
#define ALL(condition) hn::AllTrue(hn::DFromV<Real>(), condition)
#define ANY(condition) (!hn::AllFalse(hn::DFromV<Real>(), condition))
#define BY_PRECISION(single, twice) (sizeof(Uniform) == 4 ? (single) : (twice))

// Double precision has these instead, to 1e-15.

// (1 + 2 x) erfcx(x) as a polynomial in (x - 3.75) / (x + 3.75) (Shepherd and Laframboise 1981
// chose the variable; the coefficients are a Chebyshev fit in 40 digits).
template <class Real>
requires(sizeof(Uniform) == 8) HWY_INLINE Real erfcx(Real x) {
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
  const Real y = min(x, 1e150);
  const Real t = (y - 3.75) / (y + 3.75);
  Real p = lanes<Real>(coefficients[0]);
  for (std::size_t i = 1; i < std::size(coefficients); ++i) p = mul_add(p, t, coefficients[i]);
  return p / mul_add(2.0, y, 1.0);
}

FORMULA Real gauss_pair(Real e, Real m, Real k, Uniform node, Uniform weight);
template <class Real>
requires(sizeof(Uniform) == 8) HWY_INLINE Real short_mean(Real e, Real m, Real k) {
  return gauss_pair(e, m, k, 0.2386191860831969086, 0.4679139345726910474) +
         gauss_pair(e, m, k, 0.6612093864662645137, 0.3607615730481386076) +
         gauss_pair(e, m, k, 0.9324695142031520278, 0.1713244923791703450);
}

#include "render/formulas/erf.inl"
#include "render/formulas/falloff.inl"
#include "render/formulas/ggx.inl"
#include "render/formulas/maps.inl"
#include "render/formulas/noise.inl"
#include "render/formulas/phase.inl"
#include "render/formulas/slices.inl"
#include "render/formulas/surfaces.inl"

// Formulas that use those above.
#include "render/formulas/area.inl"
#include "render/formulas/fog.inl"
#include "render/formulas/line.inl"

#undef CONSTANT
#undef FORMULA_OF
#undef FORMULA
#undef FORMULA_STRUCT
#undef OF
#undef Uniform
#undef Vec2
#undef Vec3
#undef Bool
#undef BITS
#undef TO_BITS
#undef REAL
#undef SHIFT_LEFT
#undef SHIFT_RIGHT
#undef ALL
#undef ANY
#undef BY_PRECISION

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_FORMULAS_INL_H
