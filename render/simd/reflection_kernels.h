#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "core/scene/materials/brdf.h"
#include "render/simd/surface_points.h"

namespace brume {

// SIMD reflection of light given as spherical harmonics (Highway, single precision). Scalar double
// counterpart: ShMaterial::unshadowed().

// Incident light at points: R, G, B per coefficient of six bands, in world space.
struct IncidentLight {
  std::array<PointArray, 3 * sh_size(sh_max_bands)> values;

  void clear();
  // Adds light at one point.
  void add(std::size_t point, std::size_t coefficient, const glm::vec3& light) {
    for (std::size_t c = 0; c < 3; ++c) {
      values[3 * coefficient + c][point] += light[static_cast<int>(c)];
    }
  }
  void add(std::size_t point, const ShVector<glm::dvec3>& light);
};

// Incident light interpolated between the corners of a triangle: coefficients in world space, the
// same number at each; null: none.
struct MixedLight {
  std::array<const glm::vec3*, 3> corners{};
  glm::vec3 weights{0.0f};
};

// A BrdfSh as a table: one row per polar angle of the eye, with coefficients m >= 0 (the others
// vanish), R G B.
class ReflectionTable {
 public:
  explicit ReflectionTable(const BrdfSh& brdf);

  static constexpr int intervals = 64;  // of pi / 2
  static constexpr std::size_t row_size = 64;
  [[nodiscard]] const float* rows() const { return values_.data(); }

 private:
  std::vector<float> values_;
};

// sent[k] = outgoing radiance of point k towards the eye; may be slightly negative due to truncated
// bands.
void reflect(const SurfacePoints& points, const ReflectionTable& table, const IncidentLight& light,
             PointRadiance& outgoing);
// By metallic-roughness materials, see SurfacePoints::ggx and GgxSh.
void reflect_ggx(const SurfacePoints& points, const IncidentLight& light, PointRadiance& outgoing);
// With one MixedLight of `size` coefficients per point.
void reflect(const SurfacePoints& points, const ReflectionTable& table,
             std::span<const MixedLight> light, std::size_t size, PointRadiance& outgoing);

}  // namespace brume
