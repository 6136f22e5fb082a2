#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "brume/scene.h"
#include "core/scene/lights/point_lights.h"
#include "core/transport/optical_depth.h"

namespace brume {

// The contribution of one Gaussian to a view ray. Optical depths are of extinction, RGB.
struct Contribution {
  std::size_t index = 0;           // index in the medium
  glm::dvec3 optical_depth{0.0};   // of this Gaussian on the ray
  glm::dvec3 depth_in_front{0.0};  // of the Gaussians and the homogeneous fog in front of it
  glm::dvec3 emitted{0.0};         // radiance that it emits to the eye
  double fraction = 0.0;           // of white light from behind that it attenuates, by luminance
  double distance = 0.0;           // from the eye to its mean on the ray

  // Its change of a pixel whose background has the luminance 1.
  [[nodiscard]] double effect() const;
};

// The Gaussians on a ray (unit direction) up to `distance` [u], in descending order of effect.
// Each is concentrated at its mean on the ray, attenuated by those in front. Those are skipped
// whose optical depth, and what they emit unattenuated, is below `min_effect`. `medium_albedo`: of
// Gaussians without their own. Homogeneous fog is from `fog`.first to `fog`.second on the ray [u].
std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& medium_albedo,
                                        const glm::dvec3& eye, const glm::dvec3& direction,
                                        double distance = std::numeric_limits<double>::infinity(),
                                        double min_effect = 1e-3,
                                        const std::pair<double, double>& fog = {
                                            0.0, std::numeric_limits<double>::infinity()});

// The fog of a scene on a view ray. Optical depths are of extinction, for the mean albedo of the
// three channels.
class FogOnRay {
 public:
  // `direction`: unit. Homogeneous fog is from `fog`.first to `fog`.second on the ray [u].
  FogOnRay(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction,
           const std::pair<double, double>& fog);

  // Up to a distance, which may be infinite [u].
  [[nodiscard]] double optical_depth(double distance) const;
  [[nodiscard]] double optical_depth_of_gaussians(double distance) const;
  // The distance up to which it is `optical_depth` > 0; +inf if it never is [u].
  [[nodiscard]] double distance_at(double optical_depth) const;
  // The distance up to which the Gaussians alone take half of the light that they take at all;
  // nullopt if that is less than `min_opacity` of it [u].
  [[nodiscard]] std::optional<double> middle_of_gaussians(double min_opacity) const;

 private:
  struct Part {
    LineProfile<double> line;
    double extinction;  // of the Gaussian at its center [1/u]
  };
  std::vector<Part> parts_;
  double extinction_ = 0.0;  // of homogeneous fog [1/u]
  std::pair<double, double> fog_;
};

// RGB radiance that the Gaussian scatters towards the eye from one point light, evaluated at its
// mean on the ray and attenuated by the whole medium including b0 on both segments; surfaces are
// ignored. Of the way to the light, at most `fog_length` [u] passes homogeneous fog.
glm::dvec3 scattered_radiance(const Scene& scene, const Contribution& contribution,
                              const glm::dvec3& eye, const glm::dvec3& direction,
                              const PointLight& light,
                              double fog_length = std::numeric_limits<double>::infinity());

}  // namespace brume
