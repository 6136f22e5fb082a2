// Ellipsoids in SIMD, and the formulas of Gaussians. Included once per instruction set by the files
// that Highway compiles for each.

#if defined(BRUME_GAUSSIAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_GAUSSIAN_INL_H
#undef BRUME_GAUSSIAN_INL_H
#else
#define BRUME_GAUSSIAN_INL_H
#endif

#include "render/simd/formulas-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// A symmetric matrix: Ellipsoid::warp.
template <class V>
struct WarpOf {
  V xx, yy, zz, yz, xz, xy;

  HWY_INLINE V3<V> operator()(const V3<V>& v) const {
    return {dot(V3<V>{xx, xy, xz}, v), dot(V3<V>{xy, yy, yz}, v), dot(V3<V>{xz, yz, zz}, v)};
  }
};

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_GAUSSIAN_INL_H
