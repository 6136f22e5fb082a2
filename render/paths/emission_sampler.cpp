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
    const double volume = std::pow(std::numbers::pi, 1.5) / (g.a * g.a * g.a);
    const double next = sum + g.c * volume * (emission.x + emission.y + emission.z);
    if (!(next > sum) || !std::isfinite(next)) continue;
    emitting_.push_back({g.b, std::numbers::sqrt2 / (2.0 * g.a)});
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
    const double radius = g.deviation * std::sqrt(-2.0 * std::log(random.uniform()));
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    return glm::dvec2(radius * std::cos(angle), radius * std::sin(angle));
  };
  const glm::dvec2 xy = normal_pair();
  return g.center + glm::dvec3(xy, normal_pair().x);
}

}  // namespace brume
