// The rays of a PathBatch in SIMD. Included once per instruction set by the files that Highway
// compiles for each.

#if defined(BRUME_VIEW_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_VIEW_RAYS_INL_H
#undef BRUME_VIEW_RAYS_INL_H
#else
#define BRUME_VIEW_RAYS_INL_H
#endif

#include "render/simd/gaussian-inl.h"
#include "render/simd/gaussian_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

// Kernels are templates of the rays that they take: those that start at the origin of their batch
// cost nothing for the offsets of others.

template <class D>
HWY_INLINE V3<hn::Vec<D>> LoadVectors(D d, const std::vector<float>& x, const std::vector<float>& y,
                                      const std::vector<float>& z, std::size_t k) {
  return {hn::LoadU(d, x.data() + k), hn::LoadU(d, y.data() + k), hn::LoadU(d, z.data() + k)};
}

template <class D>
struct RaysFromOrigin {
  using V = hn::Vec<D>;
  V3<V> w;

  HWY_INLINE RaysFromOrigin(D d, const PathBatch& paths, std::size_t k)
      : w(LoadVectors(d, paths.x, paths.y, paths.z, k)) {}
  // A position relative to the batch's origin, relative to where the rays start.
  HWY_INLINE V3<V> From(const V3<V>& position) const { return position; }
  // The same of positions that an ellipsoid's warp has changed.
  HWY_INLINE V3<V> From(const WarpOf<V>&, const V3<V>& warped) const { return warped; }
};

template <class D>
struct ParallelRays {
  using V = hn::Vec<D>;
  V3<V> w, offset;

  HWY_INLINE ParallelRays(D d, const PathBatch& paths, std::size_t k)
      : w(LoadVectors(d, paths.x, paths.y, paths.z, k)),
        offset(LoadVectors(d, paths.offset_x, paths.offset_y, paths.offset_z, k)) {}
  HWY_INLINE V3<V> From(const V3<V>& position) const { return Difference(position, offset); }
  HWY_INLINE V3<V> From(const WarpOf<V>& warp, const V3<V>& warped) const {
    return Difference(warped, warp(offset));
  }

 private:
  static HWY_INLINE V3<V> Difference(const V3<V>& a, const V3<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
  }
};

// Calls body.template operator()<Rays>() with the type of a batch's rays.
template <class D, class Body>
HWY_INLINE decltype(auto) WithRays(D, const PathBatch& paths, const Body& body) {
  if (paths.has_offsets()) return body.template operator()<ParallelRays<D>>();
  return body.template operator()<RaysFromOrigin<D>>();
}

// The points at t on rays, relative to a position.
template <class Rays, class V = typename Rays::V>
HWY_INLINE V3<V> FromPosition(const Rays& rays, V t, const glm::vec3& position) {
  const V3<V> s = rays.From({lanes<V>(position.x), lanes<V>(position.y), lanes<V>(position.z)});
  return {mul_sub(t, rays.w.x, s.x), mul_sub(t, rays.w.y, s.y), mul_sub(t, rays.w.z, s.z)};
}

// The intervals of rays in fog.
template <class Rays, class V = typename Rays::V>
HWY_INLINE FogInterval<V> FogOnRays(const Rays& rays, const BatchFog& fog) {
  return fog_interval(FromPosition(rays, lanes<V>(0.0f), fog.center), rays.w, fog.radius);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_VIEW_RAYS_INL_H
