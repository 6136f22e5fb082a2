#include "render/lighting/environment_light.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/scene/brdf.h"
#include "core/scene/environment.h"
#include "core/scene/radiance_map.h"
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

const ScatterTable::Bands& EnvironmentLight::cosine_factors() {
  static const ScatterTable::Bands factors = [] {
    const ZonalSh<double> cosine = clamped_cosine_sh();
    ScatterTable::Bands f;
    for (std::size_t l = 0; l < f.size(); ++l) {
      f[l] = static_cast<float>(
          std::sqrt(4.0 * std::numbers::pi / (2.0 * static_cast<double>(l) + 1.0)) * cosine[l] *
          std::numbers::inv_pi);
    }
    return f;
  }();
  return factors;
}

EnvironmentLight::EnvironmentLight(const Environment& environment, const ScatterTable& scattering)
    : environment_(environment),
      scattering_(&scattering),
      light_(environment_sh(environment, sh_max_bands)),
      light_float_(sh_max_bands),
      to_map_(glm::mat3_cast(glm::conjugate(environment_rotation(environment)))) {
  for (std::size_t i = 0; i < light_.size(); ++i) light_float_[i] = glm::vec3(light_[i]);
}

void EnvironmentLight::show(const glm::dvec3& first, const glm::dvec3& per_pixel,
                            std::span<const float> distances, std::span<glm::vec3> behind) const {
  find_sky(*environment_.map, static_cast<float>(environment_.intensity),
           {glm::vec3(to_map_ * first), glm::vec3(to_map_ * per_pixel)}, distances, behind);
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

ShVector<glm::dvec3> EnvironmentLight::incident(const NodeRadiance& incident) const {
  ShVector<glm::dvec3> light(light_.order());
  const glm::dvec3 dimmed(dimming(incident));
  for (std::size_t i = 0; i < light.size(); ++i) {
    light[i] = i < sh_size(grid_bands)
                   ? environment_.intensity *
                         glm::dvec3(incident[4 * i], incident[4 * i + 1], incident[4 * i + 2])
                   : dimmed * light_[i];
  }
  return light;
}

glm::vec3 EnvironmentLight::diffuse(const glm::dvec3& n,
                                    const ScatterTable::Bands& fractions) const {
  ScatterTable::Bands factors;
  for (std::size_t l = 0; l < factors.size(); ++l) factors[l] = cosine_factors()[l] * fractions[l];
  return banded(light_float_, factors, n);
}

glm::vec3 EnvironmentLight::diffuse(const glm::dvec3& n, const NodeRadiance& incident) const {
  // The fourth and the sixth band are nothing to a diffuse surface.
  const ShVector<float> y = sh_basis(5, glm::vec3(n));
  const auto intensity = static_cast<float>(environment_.intensity);
  glm::vec3 sum(0.0f);
  for (int l = 0; l < 3; ++l) {
    glm::vec3 band(0.0f);
    for (int m = -l; m <= l; ++m) {
      const std::size_t i = sh_index(l, m);
      band += y[i] * glm::vec3(incident[4 * i], incident[4 * i + 1], incident[4 * i + 2]);
    }
    sum += intensity * cosine_factors()[static_cast<std::size_t>(l)] * band;
  }
  glm::vec3 fifth(0.0f);
  for (std::size_t i = sh_size(4); i < sh_size(5); ++i) fifth += y[i] * light_float_[i];
  return glm::max(sum + cosine_factors()[4] * dimming(incident) * fifth, 0.0f);
}

glm::vec3 EnvironmentLight::dimming(const NodeRadiance& incident) const {
  glm::vec3 fraction(0.0f);
  for (int c = 0; c < 3; ++c) {
    const float total = light_float_[0][c];
    const float direct =
        static_cast<float>(environment_.intensity) * incident[static_cast<std::size_t>(c)];
    if (total > 0.0f) fraction[c] = direct / total;
  }
  return fraction;
}

}  // namespace brume
