#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "core/scene/materials/ggx.h"

namespace brume {

// ggx_brdf() max(0, cos theta_i) as spherical harmonics of wi in surface_frame(), as BrdfSh, but
// for all materials at once: with Schlick's Fresnel term it is diffuse D + f0 A + B, where D
// depends on the angle of the eye only, and A and B on roughness and angle. Only coefficients m >=
// 0: by symmetry the others vanish.
class GgxSh {
 public:
  // The one table; made by the first call, in a tenth of a second. Thread-safe.
  static const GgxSh& table();

  static constexpr int roughness_intervals = 16;  // of [0, 1]
  static constexpr int angle_intervals = 64;      // of [0, pi / 2], the polar angle of wo
  static constexpr int coefficients = sh_max_bands * (sh_max_bands + 1) / 2;  // l, m = 0 to l
  static constexpr std::size_t row_size = 24;                                 // padded

  // Rows of coefficients by angle: D, and by roughness and then angle A and B.
  [[nodiscard]] std::span<const float> diffuse() const { return diffuse_; }
  [[nodiscard]] std::span<const float> scaled() const { return scaled_; }
  [[nodiscard]] std::span<const float> added() const { return added_; }

  // cos_theta_o in [-1, 1], clamped to >= 0. Linear between rows.
  [[nodiscard]] ShVector<glm::dvec3> operator()(const GgxReflection& reflection,
                                                double cos_theta_o) const;

 private:
  GgxSh();

  std::vector<float> diffuse_, scaled_, added_;
};

}  // namespace brume
