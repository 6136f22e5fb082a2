#include "render/paths/emission_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

namespace brume {

EmissionSampler::EmissionSampler(const MediumIndex& medium) {
  double sum = 0.0;
  for (std::size_t i = 0; i < medium.optics().size(); ++i) {
    const GaussianTerm<double>& g = medium.gaussians()[i];
    const glm::dvec3& emission = medium.optics()[i].emission;
    const double volume = volume_of(g);
    const double next = sum + g.c * volume * (emission.x + emission.y + emission.z);
    if (!(next > sum) || !std::isfinite(next)) continue;
    const double greatest = std::numbers::sqrt2 / (2.0 * g.a);
    glm::dmat3 deviation(greatest);
    for (int k = 0; g.ellipsoid && k < 3; ++k) {
      deviation[k] = greatest * g.ellipsoid->stretch[k] * g.ellipsoid->axes[k];
    }
    emitting_.push_back({g.b, deviation});
    sums_.push_back(next);
    sum = next;
  }
}

glm::dvec3 EmissionSampler::sample(PathRandom& random) const {
  const double u = sums_.back() * random.uniform();
  const auto chosen = std::min(std::ranges::upper_bound(sums_, u), sums_.end() - 1);
  const Emitting& g = emitting_[static_cast<std::size_t>(chosen - sums_.begin())];
  // Box and Muller's method, twice.
  const auto normal_pair = [&] {
    const double radius = std::sqrt(-2.0 * std::log(random.uniform()));
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    return glm::dvec2(radius * std::cos(angle), radius * std::sin(angle));
  };
  const glm::dvec2 xy = normal_pair();
  return g.center + g.deviation * glm::dvec3(xy, normal_pair().x);
}

}  // namespace brume
