#include "core/authoring/contribution.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/math/infinity.h"
#include "core/scene/lights/light_falloff.h"
#include "core/scene/lights/photometry.h"
#include "core/transport/phase_function.h"

namespace brume {

namespace {

double max_channel(const glm::dvec3& rgb) {
  return std::max({rgb.r, rgb.g, rgb.b});
}

// Whether a Gaussian is nothing to a line: most are that far from it, and this takes no
// exponential.
bool is_far(const Medium& medium, std::size_t i, const glm::dvec3& origin,
            const glm::dvec3& direction) {
  constexpr double far = 12.0;  // radii: e^-144, so that no density makes up for it
  const glm::dvec3 to_center = medium.centers()[i] - origin;
  const glm::dvec3 across = to_center - glm::dot(to_center, direction) * direction;
  const double reach = far * medium.radii()[i];
  return glm::dot(across, across) > reach * reach;
}

double mean(const glm::dvec3& rgb) {
  return (rgb.r + rgb.g + rgb.b) / 3.0;
}

// The argument at which a function that grows from 0 reaches a value that it exceeds at last.
template <class Function>
double where_it_reaches(double value, const Function& function) {
  double low = 0.0;
  double high = 1.0;
  while (function(high) < value && high < 1e30) high *= 2.0;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (function(middle) < value ? low : high) = middle;
  }
  return high;
}

glm::dvec3 opacity(const glm::dvec3& optical_depth) {
  return {-std::expm1(-optical_depth.r), -std::expm1(-optical_depth.g),
          -std::expm1(-optical_depth.b)};
}

}  // namespace

double Contribution::effect() const {
  return std::max(fraction, luminance(emitted));
}

std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& medium_albedo,
                                        const glm::dvec3& eye, const glm::dvec3& direction,
                                        double distance, double min_effect,
                                        const std::pair<double, double>& fog) {
  std::vector<Contribution> result;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (is_far(medium, i, eye, direction)) continue;
    const Gaussian gaussian = medium.gaussian(i);
    const glm::dvec3 albedo = gaussian.optics.albedo.value_or(medium_albedo);
    const StandaloneTerm term(gaussian);
    const GaussianTerm<double>& g = *term;
    const LineProfile<double> line = line_profile(g, eye, direction);
    // A scattering optical depth of 1 may change this much.
    const double scale =
        max_channel(1.0 / albedo) * std::max(1.0, max_channel(gaussian.optics.emission));
    // At most this: most Gaussians are far from the ray.
    if (1.7725 * scale * gaussian.radius * gaussian.density * std::exp(-line.e) < min_effect) {
      continue;
    }
    const double scattering = optical_depth(g, line, distance);
    if (scale * scattering < min_effect) continue;
    result.push_back({.index = i,
                      .optical_depth = scattering / albedo,
                      .distance = truncated_mean(line, distance)});
  }
  std::sort(result.begin(), result.end(),
            [](const Contribution& a, const Contribution& b) { return a.distance < b.distance; });
  glm::dvec3 gaussians_in_front(0.0);
  for (Contribution& c : result) {
    const double in_fog = std::max(std::min(c.distance, fog.second) - fog.first, 0.0);
    c.depth_in_front = gaussians_in_front + medium.homogeneous_density() * in_fog / medium_albedo;
    const glm::dvec3 attenuated = glm::exp(-c.depth_in_front) * opacity(c.optical_depth);
    c.fraction = luminance(attenuated);
    c.emitted = medium.optics(c.index).emission * attenuated;
    gaussians_in_front += c.optical_depth;
  }
  std::stable_sort(result.begin(), result.end(), [](const Contribution& a, const Contribution& b) {
    return a.effect() > b.effect();
  });
  return result;
}

FogOnRay::FogOnRay(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction,
                   const std::pair<double, double>& fog)
    : extinction_(scene.medium.homogeneous_density() / mean(scene.optics.albedo)), fog_(fog) {
  constexpr double min_optical_depth = 1e-5;  // so that all others together count for nothing
  const Medium& medium = scene.medium;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (is_far(medium, i, eye, direction)) continue;
    const Gaussian gaussian = medium.gaussian(i);
    const StandaloneTerm term(gaussian);
    const double albedo = mean(gaussian.optics.albedo.value_or(scene.optics.albedo));
    const Part part{line_profile(*term, eye, direction), gaussian.density / albedo};
    const GaussianTerm<double> g(1.0, part.extinction, {});
    if (brume::optical_depth(g, part.line, infinity) > min_optical_depth) parts_.push_back(part);
  }
}

double FogOnRay::optical_depth_of_gaussians(double distance) const {
  double sum = 0.0;
  for (const Part& part : parts_) {
    sum += brume::optical_depth({1.0, part.extinction, {}}, part.line, distance);
  }
  return sum;
}

double FogOnRay::optical_depth(double distance) const {
  const double in_fog = std::max(std::min(distance, fog_.second) - fog_.first, 0.0);
  return optical_depth_of_gaussians(distance) + (extinction_ > 0.0 ? extinction_ * in_fog : 0.0);
}

double FogOnRay::distance_at(double optical_depth) const {
  if (!(this->optical_depth(infinity) > optical_depth)) return infinity;
  return where_it_reaches(optical_depth, [this](double d) { return this->optical_depth(d); });
}

std::optional<double> FogOnRay::middle_of_gaussians(double min_opacity) const {
  const double opacity = -std::expm1(-optical_depth_of_gaussians(infinity));
  if (opacity < min_opacity) return std::nullopt;
  return where_it_reaches(-std::log1p(-0.5 * opacity),
                          [this](double d) { return optical_depth_of_gaussians(d); });
}

glm::dvec3 scattered_radiance(const Scene& scene, const Contribution& contribution,
                              const glm::dvec3& eye, const glm::dvec3& direction,
                              const PointLight& light, double fog_length) {
  const Medium& medium = scene.medium;
  const glm::dvec3 point = eye + contribution.distance * direction;
  const glm::dvec3 from_light = point - light.position;
  const double distance = glm::length(from_light);
  if (!(distance > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3& shared = scene.optics.albedo;
  glm::dvec3 depth = contribution.depth_in_front +
                     medium.homogeneous_density() * std::min(distance, fog_length) / shared;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (is_far(medium, i, light.position, from_light / distance)) continue;
    const Gaussian g = medium.gaussian(i);
    depth += optical_depth(g, light.position, point) / g.optics.albedo.value_or(shared);
  }
  const glm::dvec3 own_albedo = medium.optics(contribution.index).albedo.value_or(shared);
  const double cosine = -glm::dot(from_light, direction) / distance;
  const double falloff = light.falloff.at(from_light / distance);
  const double phase =
      henyey_greenstein(cosine, scene.optics.anisotropy) / (4.0 * glm::pi<double>());
  return falloff * phase / (distance * distance) * light.intensity * own_albedo * glm::exp(-depth) *
         opacity(contribution.optical_depth);
}

}  // namespace brume
