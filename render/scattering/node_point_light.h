#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/geometry/point_source.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/simd/gaussian_kernels.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A point light and what attenuates it on its way to the nodes of a grid.
struct NodePointLight {
  const PointSource& source;
  std::array<float, 3> intensity{};          // per channel of the nodes [W/sr]
  const OpticalDepthTable* table = nullptr;  // null: no Gaussians
  double extinction = 1.0;                   // factor of the table's optical depths
  double fog = 0.0;                          // homogeneous extinction [1/u]
  const RayCaster* surfaces = nullptr;       // that occlude it; null: none
  // Of a light that is normally distributed around its position, along each axis [u]; 0: a point.
  double deviation = 0.0;

  // The mean of 1 / r^2 from all of it at a distance of sqrt(r2) > 0 from its position.
  [[nodiscard]] double inverse_square(double r2) const;
};

// Transmittance of the medium between a light and points, without surfaces.
class LightTransmittance {
 public:
  explicit LightTransmittance(const NodePointLight& light) : light_(light) {}

  // One for each point, until the next call.
  [[nodiscard]] std::span<const double> at(std::span<const glm::dvec3> points);

 private:
  const NodePointLight& light_;
  std::vector<std::int32_t> self_;
  PathBatch paths_;
  std::vector<float> depths_;
  std::vector<double> values_;
};

}  // namespace brume
