#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "brume/revision.h"
#include "brume/scene.h"
#include "core/math/spherical_harmonics.h"
#include "render/scattering/incident_lookup.h"
#include "render/simd/scatter_table.h"

namespace brume {

// A scene's environment, as background and as incident light at surfaces.
class EnvironmentLight {
 public:
  // The map must be loaded. `scattering` outlives this.
  EnvironmentLight(const Environment& environment, const ScatterTable& scattering);

  [[nodiscard]] Revision revision() const { return revision_; }
  [[nodiscard]] bool shows(const Environment& environment, const ScatterTable& scattering) const {
    return environment_ == environment && scattering_ == &scattering;
  }

  // Spherical-harmonics coefficients of the environment without medium, and its scattering table.
  [[nodiscard]] const ShVector<glm::vec3>& coefficients() const { return light_float_; }
  [[nodiscard]] const ScatterTable& scattering() const { return *scattering_; }

  // behind[k] = radiance from direction start + (first + k) per_pixel (any length) without medium,
  // where distances[k] is infinite. Single precision.
  void show(const glm::dvec3& start, const glm::dvec3& per_pixel, int first,
            std::span<const float> distances, std::span<glm::vec3> behind) const;

  // Environment inscattering of the paper, T e^-T (L * spread)(w) (eq. 28), for a view ray of
  // optical depth T. Also used in front of surfaces.
  [[nodiscard]] glm::vec3 environment_inscattering(const glm::dvec3& w, float T) const;

  // Per band, the fraction of the environment incident at a point of average optical depth Tbar,
  // direct and scattered (eq. 27).
  [[nodiscard]] ScatterTable::Bands incident(float Tbar, double albedo) const;

  // Incident radiance at a point from per-band fractions.
  [[nodiscard]] ShVector<glm::dvec3> incident(const ScatterTable::Bands& fractions) const;

  // Radiance of a diffuse surface of reflectance 1 and unit normal n: irradiance / pi.
  [[nodiscard]] glm::vec3 diffuse(const glm::dvec3& n, const ScatterTable::Bands& fractions) const;

 private:
  Revision revision_ = new_revision();
  Environment environment_;
  const ScatterTable* scattering_;
  ShVector<glm::dvec3> light_;
  ShVector<glm::vec3> light_float_;
  glm::dmat3 to_map_;
};

// The same of `scale` times incident light from a grid. Bands beyond the grid's are those of
// `environment`, attenuated like the mean of all light; without one, none.
ShVector<glm::dvec3> incident_light(const NodeRadiance& light, double scale,
                                    const EnvironmentLight* environment);
glm::vec3 diffuse_light(const glm::dvec3& n, const NodeRadiance& light, double scale,
                        const EnvironmentLight* environment);
// The latter, for IncidentLookup::diffuse().
DiffuseFactors diffuse_factors(double scale, const EnvironmentLight* environment);

}  // namespace brume
