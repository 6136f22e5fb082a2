#include "render/scattering/environment_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/brdf.h"
#include "render/simd/composite_kernels.h"

namespace brume {
namespace {

// The sum of bands of L at a direction, each with its factor; never below 0, where six bands of
// bright light ring.
glm::vec3 banded(const ShVector<glm::vec3>& L, const ScatterTable::Bands& factors,
                 const glm::dvec3& w) {
  const ShVector<float> y = sh_basis(L.order(), glm::vec3(w));
  glm::vec3 sum(0.0f);
  for (int l = 0; l < L.order(); ++l) {
    glm::vec3 band(0.0f);
    for (int m = -l; m <= l; ++m) band += y[sh_index(l, m)] * L[sh_index(l, m)];
    sum += factors[static_cast<std::size_t>(l)] * band;
  }
  return glm::max(sum, 0.0f);
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment, const ScatterTable& scattering)
    : environment_(environment),
      scattering_(&scattering),
      light_(environment_sh(environment, sh_max_bands)),
      light_float_(sh_max_bands),
      to_map_(glm::mat3_cast(glm::conjugate(environment_rotation(environment)))) {
  for (std::size_t i = 0; i < light_.size(); ++i) light_float_[i] = glm::vec3(light_[i]);
}

void EnvironmentLight::show(const glm::dvec3& start, const glm::dvec3& per_pixel, int first,
                            std::span<const float> distances, std::span<glm::vec3> behind) const {
  find_sky(*environment_.map, static_cast<float>(environment_.intensity),
           {glm::vec3(to_map_ * start), glm::vec3(to_map_ * per_pixel), first}, distances, behind);
}

glm::vec3 EnvironmentLight::environment_inscattering(const glm::dvec3& w, float T) const {
  return banded(light_float_, (*scattering_)(T), w);
}

ScatterTable::Bands EnvironmentLight::incident(float Tbar, double albedo) const {
  const float unscattered = std::exp(-Tbar);
  ScatterTable::Bands fractions = (*scattering_)(Tbar);
  for (float& fraction : fractions) fraction = unscattered + static_cast<float>(albedo) * fraction;
  return fractions;
}

ShVector<glm::dvec3> EnvironmentLight::incident(const ScatterTable::Bands& fractions) const {
  ShVector<glm::dvec3> light(light_.order());
  for (int l = 0; l < light.order(); ++l) {
    const auto fraction = static_cast<double>(fractions[static_cast<std::size_t>(l)]);
    for (int m = -l; m <= l; ++m) light[sh_index(l, m)] = fraction * light_[sh_index(l, m)];
  }
  return light;
}

glm::vec3 EnvironmentLight::diffuse(const glm::dvec3& n,
                                    const ScatterTable::Bands& fractions) const {
  ScatterTable::Bands factors;
  for (std::size_t l = 0; l < factors.size(); ++l)
    factors[l] = clamped_cosine_factors()[l] * fractions[l];
  return banded(light_float_, factors, n);
}

namespace {

glm::vec3 coefficient(const NodeRadiance& light, std::size_t i) {
  return {light[4 * i], light[4 * i + 1], light[4 * i + 2]};
}

// The mean incident light relative to that of the environment without medium, at most 1: what is
// more is not the environment's.
glm::vec3 dimming(const NodeRadiance& light, double scale, const EnvironmentLight& environment) {
  const glm::vec3 mean = static_cast<float>(scale) * coefficient(light, 0);
  glm::vec3 fraction(0.0f);
  for (int c = 0; c < 3; ++c) {
    const float total = environment.coefficients()[0][c];
    if (total > 0.0f) fraction[c] = std::min(mean[c] / total, 1.0f);
  }
  return fraction;
}

}  // namespace

ShVector<glm::dvec3> incident_light(const NodeRadiance& light, double scale,
                                    const EnvironmentLight* environment) {
  ShVector<glm::dvec3> incident(sh_max_bands);
  for (std::size_t i = 0; i < sh_size(grid_bands); ++i) {
    incident[i] = scale * glm::dvec3(coefficient(light, i));
  }
  if (!environment) return incident;
  const glm::vec3 dimmed = dimming(light, scale, *environment);
  for (std::size_t i = sh_size(grid_bands); i < incident.size(); ++i) {
    incident[i] = glm::dvec3(dimmed * environment->coefficients()[i]);
  }
  return incident;
}

glm::vec3 diffuse_light(const glm::dvec3& n, const NodeRadiance& light, double scale,
                        const EnvironmentLight* environment) {
  // The fourth and the sixth band are nothing to a diffuse surface.
  const ShVector<float> y = sh_basis(5, glm::vec3(n));
  const ScatterTable::Bands& cosine = clamped_cosine_factors();
  glm::vec3 sum(0.0f);
  for (int l = 0; l < 3; ++l) {
    glm::vec3 band(0.0f);
    for (std::size_t i = sh_size(l); i < sh_size(l + 1); ++i) band += y[i] * coefficient(light, i);
    sum += static_cast<float>(scale) * cosine[static_cast<std::size_t>(l)] * band;
  }
  if (environment) {
    glm::vec3 fifth(0.0f);
    for (std::size_t i = sh_size(4); i < sh_size(5); ++i) {
      fifth += y[i] * environment->coefficients()[i];
    }
    sum += cosine[4] * dimming(light, scale, *environment) * fifth;
  }
  return glm::max(sum, 0.0f);
}

DiffuseFactors diffuse_factors(double scale, const EnvironmentLight* environment) {
  const ScatterTable::Bands& cosine = clamped_cosine_factors();
  DiffuseFactors factors;
  for (std::size_t l = 0; l < 3; ++l) factors.bands[l] = static_cast<float>(scale) * cosine[l];
  if (!environment) return factors;
  factors.bands[4] = cosine[4];
  const ShVector<glm::vec3>& sky = environment->coefficients();
  for (int c = 0; c < 3; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    for (std::size_t i = sh_size(4); i < sh_size(5); ++i) {
      factors.fifth_band[4 * (i - sh_size(4)) + channel] = sky[i][c];
    }
    const float mean = sky[0][c];
    if (mean > 0.0f) factors.per_mean[channel] = static_cast<float>(scale) / mean;
  }
  return factors;
}

}  // namespace brume
