#include "render/geometry/medium_index.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace brume {

double CullingTolerance::of(const Gaussian& gaussian) const {
  const double peak = std::sqrt(std::numbers::pi) * gaussian.density * gaussian.radius;
  return std::max(depth, std::min(share * peak, max_depth));
}

MediumIndex::MediumIndex(const Medium& medium, const CullingTolerance& tolerance, double anisotropy)
    : optics_(relative_optics(medium)),
      b0_(medium.homogeneous_density()),
      tolerance_(tolerance),
      anisotropy_(anisotropy) {
  gaussians_.reserve(medium.size());
  cutoff_radii_.reserve(medium.size());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const Gaussian g = medium.gaussian(i);
    gaussians_.add(g);
    cutoff_radii_.push_back(brume::cutoff_radius(g.radius, g.density, tolerance.of(g)));
    if (cutoff_radii_.back() > 0.0) max_radius_ = std::max(max_radius_, g.radius);
  }
  bvh_ = SphereBvh(medium.centers(), cutoff_radii_);
}

double MediumIndex::max_displacement() const {
  return noise_.on() ? RayNoise::max_shift * noise_.amplitude() * max_radius_ : 0.0;
}

double MediumIndex::density(const glm::dvec3& x) const {
  double sum = homogeneous_density_at(x);
  bvh_.query(RaySegment{x, {0.0, 0.0, 1.0}, 0.0}, [&](std::uint32_t i) {
    const GaussianTerm<double>& g = gaussians_[i];
    const glm::dvec3 q = g.scaled(x);
    sum += g.c * std::exp(-glm::dot(q, q));
  });
  return sum;
}

RelativeOptics MediumIndex::optics_at(const glm::dvec3& x, double fog) const {
  if (optics_.empty()) return {};
  OpticsMean mean(fog);
  bvh_.query(RaySegment{x, {0.0, 0.0, 1.0}, 0.0}, [&](std::uint32_t i) {
    const GaussianTerm<double>& g = gaussians_[i];
    const glm::dvec3 q = g.scaled(x);
    mean.add(g.c * std::exp(-glm::dot(q, q)), optics_[i]);
  });
  return mean.mean();
}

double MediumIndex::depth(const RaySegment& segment) const {
  if (!(segment.length > 0.0)) return 0.0;
  double sum = fog_depth(segment.origin, segment.direction, segment.length);
  bvh_.query(segment, [&](std::uint32_t i) {
    sum +=
        optical_depth(gaussians_[i], line_profile(gaussians_[i], segment.origin, segment.direction),
                      segment.length);
  });
  return sum;
}

std::vector<RelativeOptics> relative_optics(const Medium& extinction) {
  std::vector<RelativeOptics> all;
  if (!extinction.has_albedos() && !extinction.has_emission()) return all;
  for (std::size_t i = 0; i < extinction.size(); ++i) {
    const GaussianOptics optics = extinction.optics(i);
    all.push_back({optics.albedo ? optics.albedo->x : 1.0, optics.emission});
  }
  return all;
}

CullingTolerance culling_tolerance(const Medium& medium, double error) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    deepest = std::max(deepest, medium.densities()[i] * medium.radii()[i]);
  }
  deepest *= std::sqrt(std::numbers::pi);
  const double count = static_cast<double>(std::max<std::size_t>(medium.size(), 1));
  const double of_one = 0.06 * error * std::min(1.0, deepest);
  const double of_each = 16.0 * error / count * std::min(1.0, deepest);
  return {std::min(of_one, of_each), error / 3.0, of_one};
}

}  // namespace brume
