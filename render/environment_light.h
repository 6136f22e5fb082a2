#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/math/spherical_harmonics.h"
#include "core/scene/scene.h"
#include "render/cpu/scatter_table.h"
#include "render/cpu/source_look_up.h"

namespace brume {

// A scene's environment as seen through the medium and as its surfaces receive it.
class EnvironmentLight {
 public:
  // The map must be loaded. `scattering` outlives this.
  EnvironmentLight(const Environment& environment, const ScatterTable& scattering);

  [[nodiscard]] bool shows(const Environment& environment, const ScatterTable& scattering) const {
    return environment_ == environment && scattering_ == &scattering;
  }

  // Of the environment without a medium, and how one scatters it.
  [[nodiscard]] const ShVector<glm::vec3>& coefficients() const { return light_float_; }
  [[nodiscard]] const ScatterTable& scattering() const { return *scattering_; }

  // behind[k] = radiance from direction first + k per_pixel (any length) without the medium, in
  // single precision; where distances[k] is infinite.
  void show(const glm::dvec3& first, const glm::dvec3& per_pixel, std::span<const float> distances,
            std::span<glm::vec3> behind) const;

  // What a medium of optical depth T along a view ray scatters into it as the paper has it:
  // T e^-T (L * spread)(w) (eq. 28), here also in front of surfaces, where its mist would be black.
  [[nodiscard]] glm::vec3 glow(const glm::dvec3& w, float T) const;

  // Band by band, how much of the light arrives at a point of average optical depth Tbar, straight
  // and scattered (eq. 27).
  [[nodiscard]] ScatterTable::Bands arriving(float Tbar, double albedo) const;

  // Coefficients of what arrives at a point: with those shares, or what a SourceGrid has there of
  // the map as it is. The bands that the grid does not keep are dimmed as the mean of all light is.
  [[nodiscard]] ShVector<glm::dvec3> incident(const ScatterTable::Bands& shares) const;
  [[nodiscard]] ShVector<glm::dvec3> incident(const ArrivingLight& light) const;

  // What a surface of reflectance 1 and unit normal n makes of incident(): its irradiance / pi.
  [[nodiscard]] glm::vec3 diffuse(const glm::dvec3& n, const ScatterTable::Bands& shares) const;
  [[nodiscard]] glm::vec3 diffuse(const glm::dvec3& n, const ArrivingLight& light) const;
  // What it makes of each band: convolution with max(0, cos theta) / pi.
  static const ScatterTable::Bands& cosine_factors();

 private:
  // The mean of the light that arrives beside that without a medium, R G B.
  [[nodiscard]] glm::vec3 dimming(const ArrivingLight& light) const;

  Environment environment_;
  const ScatterTable* scattering_;
  ShVector<glm::dvec3> light_;
  ShVector<glm::vec3> light_float_;
  glm::dmat3 to_map_;
};

}  // namespace brume
