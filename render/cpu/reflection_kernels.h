#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "core/scene/brdf.h"
#include "render/cpu/surface_points.h"

namespace brume {

// Reflection of light given as spherical harmonics, in single precision (Highway). The plain double
// counterpart, for single points, is ShMaterial::unshadowed().

// Light that arrives at points: for each coefficient of six bands R, G, B, in the world.
struct IncidentLight {
  std::array<PointArray, 3 * sh_size(sh_most_bands)> values;

  void clear();
  // At one point.
  void add(std::size_t point, std::size_t coefficient, const glm::vec3& light) {
    for (std::size_t c = 0; c < 3; ++c) {
      values[3 * coefficient + c][point] += light[static_cast<int>(c)];
    }
  }
  void add(std::size_t point, const ShVector<glm::dvec3>& light);
};

// Light that arrives at a point of a triangle as its corners have it: each the same number of
// coefficients, in the world; null: none.
struct MixedLight {
  std::array<const glm::vec3*, 3> corners{};
  glm::vec3 weights{0.0f};
};

// A BrdfSh as the kernel reads it: rows of polar angles of the eye, each with the coefficients
// m >= 0 (the others vanish), R G B.
class ReflectionTable {
 public:
  explicit ReflectionTable(const BrdfSh& brdf);

  static constexpr int intervals = 64;  // of pi / 2
  static constexpr std::size_t row_size = 64;
  [[nodiscard]] const float* rows() const { return values_.data(); }

 private:
  std::vector<float> values_;
};

// sent[k] = the radiance that point k sends to the eye; what few bands make negative is left so.
void reflect(const SurfacePoints& points, const ReflectionTable& table, const IncidentLight& light,
             PointRadiance& sent);
// Of one MixedLight for each point, of `size` coefficients.
void reflect(const SurfacePoints& points, const ReflectionTable& table,
             std::span<const MixedLight> light, std::size_t size, PointRadiance& sent);

}  // namespace brume
