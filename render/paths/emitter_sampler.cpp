#include "render/paths/emitter_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "brume/mesh_arrays.h"

namespace brume {

EmitterSampler::EmitterSampler(std::span<const Surface> surfaces)
    : triangles_(emitting_triangles(surfaces)), firsts_(surfaces.size(), -1) {
  for (const Surface& surface : surfaces) {
    face_counts_.push_back(to_arrays(*surface.mesh).triangles.size());
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const EmittingTriangle& triangle = triangles_[i];
    std::int64_t& first = firsts_[triangle.surface];
    if (first < 0) first = static_cast<std::int64_t>(i);
    const glm::dvec3& radiance = triangle.radiance;
    const double power =
        glm::length(area_vector(triangle.corners)) * (radiance.x + radiance.y + radiance.z);
    if (std::isfinite(sum + power)) sum += power;
    sums_.push_back(sum);
  }
}

EmitterSampler::Point EmitterSampler::sample(PathRandom& random) const {
  const double wanted = sums_.back() * random.uniform();
  const auto chosen = std::min(std::ranges::upper_bound(sums_, wanted), sums_.end() - 1);
  const EmittingTriangle& triangle = triangles_[static_cast<std::size_t>(chosen - sums_.begin())];
  const auto& [a, b, c] = triangle.corners;
  const double root = std::sqrt(random.uniform());
  const double v = random.uniform() * root;
  return {(1.0 - root) * a + (root - v) * b + v * c, triangle.surface, triangle.index,
          triangle.copy};
}

double EmitterSampler::pdf(const SurfaceHit& hit, const glm::dvec3& w) const {
  if (empty() || !hit) return 0.0;
  const std::int64_t first = firsts_[static_cast<std::size_t>(hit.surface)];
  if (first < 0) return 0.0;
  const std::size_t i = static_cast<std::size_t>(first) +
                        hit.copy * face_counts_[static_cast<std::size_t>(hit.surface)] +
                        hit.triangle;
  const double share = (sums_[i] - (i > 0 ? sums_[i - 1] : 0.0)) / sums_.back();
  // Its area as the ray sees it.
  const double facing = std::abs(glm::dot(area_vector(triangles_[i].corners), w));
  return facing > 0.0 ? share * hit.distance * hit.distance / facing : 0.0;
}

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
