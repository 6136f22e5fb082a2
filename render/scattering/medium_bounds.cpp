#include "render/scattering/medium_bounds.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <vector>

#include "core/math/substantial.h"

namespace brume {

MediumBounds medium_bounds(std::span<const GaussianTerm<double>> gaussians,
                           const EmissionLights* emission) {
  constexpr double radii = 2.5;
  std::vector<GaussianExtent> extents;
  extents.reserve(gaussians.size());
  for (const GaussianTerm<double>& g : gaussians) {
    const glm::dvec3 reach = radii / g.a * (g.ellipsoid ? g.ellipsoid->reach() : glm::dvec3(1.0));
    extents.push_back({g.b - reach, g.b + reach, central_depth(g)});
  }
  if (emission) {
    for (const EmissionLights::Light& light : emission->lights()) {
      for (const std::size_t i : light.gaussians) extents[i].emits = true;
    }
  }
  MediumBounds bounds;
  for (const std::size_t i : substantial_gaussians(extents)) {
    if (!(gaussians[i].c > 0.0)) continue;
    bounds.low = glm::min(bounds.low, extents[i].low);
    bounds.high = glm::max(bounds.high, extents[i].high);
    bounds.min_radius = std::min(bounds.min_radius, min_radius_of(gaussians[i]));
  }
  return bounds;
}

}  // namespace brume
