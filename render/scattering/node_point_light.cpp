#include "render/scattering/node_point_light.h"

#include <cmath>
#include <numbers>

#include "core/math/special_functions.h"
#include "render/slices/slice_kernels.h"

namespace brume {

double NodePointLight::inverse_square(double r2) const {
  const double variance = deviation * deviation;
  const double ratio = variance / r2;
  if (ratio < 1.0 / 36.0) return (1.0 + ratio * (1.0 + 3.0 * ratio)) / r2;
  const double r = std::sqrt(r2);
  return std::numbers::sqrt2 / (deviation * r) * dawson(r / (std::numbers::sqrt2 * deviation));
}

std::span<const double> LightTransmittance::at(std::span<const glm::dvec3> points) {
  self_.assign(points.size(), -1);
  paths_.assign(light_.source.position, points, self_);
  depths_.assign(paths_.padded_size(), 0.0f);
  if (light_.table) lookup_depths(*light_.table, paths_, depths_.data());
  values_.resize(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    values_[k] = std::exp(-light_.extinction * static_cast<double>(depths_[k]) -
                          light_.fog * light_.source.fog_length(points[k]));
  }
  return values_;
}

}  // namespace brume
