#include "core/authoring/contribution.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/scene/light_falloff.h"
#include "core/transport/optical_depth.h"
#include "core/transport/phase_function.h"

namespace brume {

std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& eye,
                                        const glm::dvec3& direction, double distance,
                                        double min_optical_depth) {
  std::vector<Contribution> result;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const GaussianTerm<double> g(medium.gaussian(i));
    const LineProfile<double> line = line_profile(g, eye, direction);
    // At most this: most Gaussians are far from the ray.
    if (1.7725 * medium.radii()[i] * medium.densities()[i] * std::exp(-line.e) < min_optical_depth)
      continue;
    const double depth = optical_depth(g, line, distance);
    if (depth >= min_optical_depth) {
      result.push_back(
          {.index = i, .optical_depth = depth, .distance = truncated_mean(g, line, distance)});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const Contribution& a, const Contribution& b) { return a.distance < b.distance; });
  double depth_in_front = 0.0;
  for (Contribution& c : result) {
    c.fraction = -std::exp(-depth_in_front) * std::expm1(-c.optical_depth);
    c.depth_in_front = depth_in_front;
    depth_in_front += c.optical_depth;
  }
  std::stable_sort(result.begin(), result.end(), [](const Contribution& a, const Contribution& b) {
    return a.fraction > b.fraction;
  });
  return result;
}

glm::dvec3 scattered_radiance(const Scene& scene, const Contribution& contribution,
                              const glm::dvec3& eye, const glm::dvec3& direction,
                              const PointLight& light, double fog_length) {
  const Medium& medium = scene.medium;
  const glm::dvec3 point = eye + contribution.distance * direction;
  const glm::dvec3 from_light = point - light.position;
  const double distance = glm::length(from_light);
  if (!(distance > 0.0)) return glm::dvec3(0.0);
  const double scattering =
      contribution.depth_in_front +
      medium.homogeneous_density() * (contribution.distance + std::min(distance, fog_length));
  // What is lost is more than what is scattered, by the albedo; in front by the medium's.
  const glm::dvec3& shared = scene.optics.albedo;
  glm::dvec3 depth = scattering / shared;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const Gaussian g = medium.gaussian(i);
    depth += optical_depth(GaussianTerm<double>(g), light.position, point) /
             g.optics.albedo.value_or(shared);
  }
  const glm::dvec3 own = medium.optics(contribution.index).albedo.value_or(shared);
  const double cosine = -glm::dot(from_light, direction) / distance;
  const double falloff = light.falloff.at(from_light / distance);
  const double phase =
      henyey_greenstein(cosine, scene.optics.anisotropy) / (4.0 * glm::pi<double>());
  glm::dvec3 radiance(0.0);
  for (int k = 0; k < 3; ++k) {
    radiance[k] = falloff * light.intensity[k] / (distance * distance) * phase * own[k] *
                  std::exp(-depth[k]) * -std::expm1(-contribution.optical_depth / own[k]);
  }
  return radiance;
}

}  // namespace brume
