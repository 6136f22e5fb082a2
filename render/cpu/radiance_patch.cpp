#include "render/cpu/radiance_patch.h"

#include <algorithm>
#include <cmath>

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/radiance_patch.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void EvaluatePatches(std::span<const RadiancePatch* const> patches, std::span<const glm::vec2> uv,
                     std::span<glm::vec3> radiance) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const float u = uv[k].x;
    const float v = uv[k].y;
#if HWY_TARGET == HWY_SCALAR
    radiance[k] = patches[k]->at(u, v);
#else
    // R G B and what follows.
    const hn::FixedTag<float, 4> d;
    const hn::FixedTag<std::int32_t, 4> d32;
    const hn::FixedTag<std::int16_t, 4> d16;
    const std::int16_t* coefficients = patches[k]->coefficients.data();
    const auto coefficient = [&](std::size_t i) HWY_ATTR {
      return hn::ConvertTo(d, hn::PromoteTo(d32, hn::LoadU(d16, coefficients + 3 * i)));
    };
    const auto along_u = hn::Set(d, u);
    const auto along_v = hn::Set(d, v);
    // c0 + u (c1 + u c3 + v c4) + v (c2 + v c5)
    const auto of_u =
        hn::MulAdd(along_u, coefficient(3), hn::MulAdd(along_v, coefficient(4), coefficient(1)));
    const auto of_v = hn::MulAdd(along_v, coefficient(5), coefficient(2));
    const auto sum = hn::MulAdd(along_u, of_u, hn::MulAdd(along_v, of_v, coefficient(0)));
    alignas(16) std::array<float, 4> sent;
    hn::Store(hn::Max(hn::Mul(hn::Set(d, patches[k]->unit), sum), hn::Zero(d)), d, sent.data());
    radiance[k] = {sent[0], sent[1], sent[2]};
#endif
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(EvaluatePatches);

RadiancePatch::RadiancePatch(const std::array<glm::vec3, 6>& values) {
  const auto& [a, b, c, ab, bc, ca] = values;
  const std::array<glm::vec3, 6> exact{a,
                                       4.0f * ab - 3.0f * a - b,
                                       4.0f * ca - 3.0f * a - c,
                                       2.0f * (a + b) - 4.0f * ab,
                                       4.0f * (a + bc - ab - ca),
                                       2.0f * (a + c) - 4.0f * ca};
  float most = 0.0f;
  for (const glm::vec3& v : exact) {
    most = std::max({most, std::abs(v.r), std::abs(v.g), std::abs(v.b)});
  }
  unit = most / 32767.0f;
  if (!(unit > 0.0f) || !std::isfinite(unit)) return;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      coefficients[3 * i + k] =
          static_cast<std::int16_t>(std::lround(exact[i][static_cast<int>(k)] / unit));
    }
  }
}

void evaluate_patches(std::span<const RadiancePatch* const> patches, std::span<const glm::vec2> uv,
                      std::span<glm::vec3> radiance) {
  HWY_DYNAMIC_DISPATCH(EvaluatePatches)(patches, uv, radiance);
}

}  // namespace brume
#endif
