#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/math/spherical_harmonics.h"
#include "core/scene/scene.h"
#include "render/cpu/scatter_table.h"

namespace brume {

// A scene's environment as seen through the medium and as its surfaces receive it.
class EnvironmentLight {
 public:
  // The map must be loaded. `scattering` outlives this.
  EnvironmentLight(const Environment& environment, const ScatterTable& scattering);

  [[nodiscard]] bool shows(const Environment& environment, const ScatterTable& scattering) const {
    return environment_ == environment && scattering_ == &scattering;
  }

  // Radiance from a unit direction without the medium, in single precision.
  [[nodiscard]] glm::vec3 radiance(const glm::vec3& w) const;

  // What a medium of optical depth T along a view ray scatters into it as the paper has it:
  // T e^-T (L * spread)(w) (eq. 28), here also in front of surfaces, where its mist would be black.
  [[nodiscard]] glm::vec3 glow(const glm::dvec3& w, float T) const;

  // Coefficients of what arrives at a point of average optical depth Tbar (eq. 27).
  [[nodiscard]] ShVector<glm::dvec3> incident(float Tbar, double albedo) const;

  // What a surface of reflectance 1 and unit normal n makes of incident(): its irradiance / pi.
  [[nodiscard]] glm::vec3 diffuse(const glm::dvec3& n, float Tbar, double albedo) const;

 private:
  Environment environment_;
  const ScatterTable* scattering_;
  ShVector<glm::dvec3> light_;
  ShVector<glm::vec3> light_float_;
  glm::mat3 to_map_;
};

}  // namespace brume
