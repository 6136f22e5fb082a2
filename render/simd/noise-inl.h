// Gaussians of a batch on view rays, which noise may displace. Included once per instruction set by
// the files that Highway compiles for each.

#if defined(BRUME_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_NOISE_INL_H
#undef BRUME_NOISE_INL_H
#else
#define BRUME_NOISE_INL_H
#endif

#include "render/simd/gaussian-inl.h"
#include "render/simd/gaussian_kernels.h"
#include "render/simd/view_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// Lattice positions of where rays start.
template <class D>
HWY_INLINE V3<hn::Vec<D>> NoiseCell(D d, const BatchNoise& noise, const RaysFromOrigin<D>&) {
  return {hn::Set(d, noise.x), hn::Set(d, noise.y), hn::Set(d, noise.z)};
}
template <class D>
HWY_INLINE V3<hn::Vec<D>> NoiseCell(D d, const BatchNoise& noise, const ParallelRays<D>& rays) {
  const auto cell = [&](hn::Vec<D> offset, float origin) HWY_ATTR {
    return hn::MulAdd(hn::Set(d, noise.frequency), offset, hn::Set(d, origin));
  };
  return {cell(rays.offset.x, noise.x), cell(rays.offset.y, noise.y), cell(rays.offset.z, noise.z)};
}

// Displaces a ray that passes a Gaussian at the vector p from its center, as warped.
template <class D, class Rays, class V = hn::Vec<D>>
HWY_INLINE void Displace(D d, const BatchNoise& noise, const V3<V>& p, const Rays& rays, V a,
                         LineProfile<V>& line) {
  const V3<V>& w = rays.w;
  const V along = clamp(noise.frequency * line.t0, -max_lattice_distance, max_lattice_distance);
  const auto key = hn::Set(hn::RebindToUnsigned<D>(), noise.key);
  const V3<V> gradient = potential_gradient(mul_add(along, w, NoiseCell(d, noise, rays)), w, key);
  line.e = displaced_e(p, w, gradient, a, noise.amplitude);
}

// The warp of an ellipsoid of a batch.
template <class D, class V = hn::Vec<D>>
HWY_INLINE WarpOf<V> BatchWarp(D d, const BatchEllipsoid& e) {
  const auto set = [&](int k) HWY_ATTR { return hn::Set(d, e.warp[static_cast<std::size_t>(k)]); };
  return {set(0), set(1), set(2), set(3), set(4), set(5)};
}

// Gaussian j of a batch as rays meet it. A kernel for balls does not test for ellipsoids, and one
// without noise not for displaced rays.
template <BatchKind kKind, class D, class Rays, class V = hn::Vec<D>>
HWY_INLINE LineProfile<V> BatchLineProfile(D d, const GaussianBatch& g, std::size_t j,
                                           const Rays& rays) {
  const V3<V>& w = rays.w;
  const V a = hn::Set(d, g.a[j]);
  const auto displaced = [&](LineProfile<V> line, const V3<V>& b, const V3<V>& v) HWY_ATTR {
    if (!hn::AllTrue(d, line.e > g.max_undisplaced_e[j])) {
      Displace(d, g.noise, neg_mul_add(line.t0, v, b), rays, a, line);
    }
    return line;
  };
  if constexpr (kKind == BatchKind::ellipsoids) {
    if (g.is_ellipsoid(j)) {
      const BatchEllipsoid& ellipsoid = g.ellipsoids[j];
      const glm::vec3& center = ellipsoid.center;
      const WarpOf<V> warp = BatchWarp(d, ellipsoid);
      const V3<V> b =
          rays.From(warp, {hn::Set(d, center.x), hn::Set(d, center.y), hn::Set(d, center.z)});
      const V3<V> v = warp(w);
      const LineProfile<V> line = warped_line_profile(b, v, a);
      return g.noise.on() ? displaced(line, b, v) : line;
    }
  }
  const V3<V> b = rays.From({hn::Set(d, g.x[j]), hn::Set(d, g.y[j]), hn::Set(d, g.z[j])});
  const LineProfile<V> line = line_profile(b, w, a);
  if (kKind == BatchKind::displaced_balls || (kKind == BatchKind::ellipsoids && g.noise.on())) {
    return displaced(line, b, w);
  }
  return line;
}

// Half the optical depth of a line through the center of Gaussian j, in the line's direction.
template <BatchKind kKind, class D, class V = hn::Vec<D>>
HWY_INLINE V BatchHalfDepth(D d, const GaussianBatch& g, std::size_t j,
                            const LineProfile<V>& line) {
  if constexpr (kKind == BatchKind::ellipsoids) {
    if (g.is_ellipsoid(j)) return g.scale[j] * g.a[j] / line.a;
  }
  return hn::Set(d, g.scale[j]);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_NOISE_INL_H
