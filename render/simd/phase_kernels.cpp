#include "render/simd/phase_kernels.h"

#include <cmath>
#include <numbers>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/phase_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

// 1 + g^2 - 2 g cos is (1 - |g|)^2 + |g| |w -+ d|^2, of which nothing cancels in the peak.
void AddPhased(std::span<const PhasedLight> lights, double anisotropy,
               const std::array<std::span<const float>, 3>& directions,
               const std::array<std::span<float>, 3>& sums) {
  const D d;
  const double g = std::abs(anisotropy);
  const float sign = anisotropy < 0.0 ? -1.0f : 1.0f;
  const V width = hn::Set(d, static_cast<float>(g));
  const V min_distance2 = hn::Set(d, static_cast<float>((1.0 - g) * (1.0 - g)));
  const V scale = hn::Set(d, static_cast<float>((1.0 - g * g) / (4.0 * std::numbers::pi)));
  for (std::size_t i = 0; i < directions[0].size(); i += hn::Lanes(d)) {
    const V x = hn::LoadU(d, directions[0].data() + i);
    const V y = hn::LoadU(d, directions[1].data() + i);
    const V z = hn::LoadU(d, directions[2].data() + i);
    V red = hn::Zero(d);
    V green = hn::Zero(d);
    V blue = hn::Zero(d);
    for (const PhasedLight& light : lights) {
      const V dx = hn::Sub(x, hn::Set(d, sign * light.direction.x));
      const V dy = hn::Sub(y, hn::Set(d, sign * light.direction.y));
      const V dz = hn::Sub(z, hn::Set(d, sign * light.direction.z));
      const V distance2 = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
      const V s = hn::MulAdd(width, distance2, min_distance2);
      const V phase = hn::Div(scale, hn::Mul(s, hn::Sqrt(s)));
      red = hn::MulAdd(phase, hn::Set(d, light.irradiance.x), red);
      green = hn::MulAdd(phase, hn::Set(d, light.irradiance.y), green);
      blue = hn::MulAdd(phase, hn::Set(d, light.irradiance.z), blue);
    }
    hn::StoreU(hn::Add(hn::LoadU(d, sums[0].data() + i), red), d, sums[0].data() + i);
    hn::StoreU(hn::Add(hn::LoadU(d, sums[1].data() + i), green), d, sums[1].data() + i);
    hn::StoreU(hn::Add(hn::LoadU(d, sums[2].data() + i), blue), d, sums[2].data() + i);
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(AddPhased);

void add_phased(std::span<const PhasedLight> lights, double anisotropy,
                const std::array<std::span<const float>, 3>& directions,
                const std::array<std::span<float>, 3>& sums) {
  HWY_DYNAMIC_DISPATCH(AddPhased)(lights, anisotropy, directions, sums);
}

}  // namespace brume
#endif
