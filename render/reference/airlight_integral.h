#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/scene/lights/light_falloff.h"
#include "core/scene/ray_noise.h"
#include "core/transport/light_path.h"
#include "render/geometry/fog_ball.h"
#include "render/geometry/medium_index.h"
#include "render/reference/gaussian_sums.h"

namespace brume {

// The single-scattering integral (eq. 4 of the paper) along one view ray, converged: ground truth
// for all approximations. Exact optical depths, adaptive quadrature in the equi-angular variable,
// intervals placed by the Gaussians on the ray.

// The medium along a view ray [0, d] from the eye in the unit direction w.
template <class Real>
class ViewRayMedium {
 public:
  // `gaussians`: at least those that touch the ray. d may be +inf. `noise` displaces the ray.
  // `optics`: of the Gaussians; empty: all as by default. `fog`: where b0 is on the ray.
  ViewRayMedium(std::span<const GaussianTerm<Real>> gaussians, Real b0, const Vec3<Real>& eye,
                const Vec3<Real>& w, Real d, const RayNoise& noise = {},
                std::span<const RelativeOptics> optics = {}, const FogInterval& fog = {});

  // Scattering coefficient of the Gaussians at t [1/u], and T(v, x(t)) with b0. t may be +inf.
  [[nodiscard]] typename Crossings<Real>::Sums at(Real t) const;
  [[nodiscard]] Real depth(Real t) const { return at(t).depth; }
  [[nodiscard]] Real homogeneous_density(Real t) const {
    return fog.contains(static_cast<double>(t)) ? b0 : Real(0);
  }

  // Of what is at t, with b0; means weighted by density.
  [[nodiscard]] RelativeOptics optics_at(Real t) const;
  [[nodiscard]] bool has_optics() const { return !optics_.empty(); }

  // The smallest t with depth(t) >= `level`, or d.
  [[nodiscard]] Real parameter_at_depth(Real level) const;

  // The interval of the ray where one Gaussian matters, and the longest subinterval that a 15-point
  // rule integrates accurately.
  struct Feature {
    Real begin, end, longest;
  };
  [[nodiscard]] std::span<const Feature> features() const { return features_; }

  const Vec3<Real> eye, w;
  const Real d;
  const Real b0;
  const FogInterval fog;

 private:
  // Where the ray crosses a Gaussian with optics of its own, or others beside such.
  struct OpticsCrossing {
    Real a, t0, peak;
    RelativeOptics optics;
  };
  Crossings<Real> crossings_;
  std::vector<Feature> features_;
  std::vector<OpticsCrossing> optics_;
};

enum class ScatteredBy { everything, gaussians, homogeneous };

template <class Real>
struct LightSource {
  Vec3<Real> position;
  Real h_min;  // minimum distance of the light from a ray, see PointLightRay
  // Gaussians that touch the triangle between light and ray.
  std::span<const GaussianTerm<Real>> gaussians;
  Real anisotropy;  // see henyey_greenstein()
  // Intervals [t0, t1] of the ray that are not in shadow; nullopt: all of it.
  std::optional<std::vector<std::pair<Real, Real>>> lit;
  LightFalloff falloff{};
  FogBall fog{};  // see PointSource
};

// Radiance scattered once towards the eye, per unit of radiant intensity [1/u^2]:
//   1 / (4 pi) * integral over [0, d] of b(t) F(t) / r(t)^2 exp(-T(v, x) - T(s, x)) dt,
// with F the light's falloff, and b restricted to `part` of the medium. `tolerance` is the relative
// error estimate at which the quadrature stops.
template <class Real>
Real airlight_integral(const ViewRayMedium<Real>& medium, const LightSource<Real>& light,
                       Real tolerance, ScatteredBy scattered_by = ScatteredBy::everything);

// Radiance that the Gaussians of the ray emit towards the eye, times what the medium lets through.
glm::dvec3 emission_integral(const ViewRayMedium<double>& medium, double tolerance);

extern template class ViewRayMedium<double>;
extern template class ViewRayMedium<float>;
extern template double airlight_integral(const ViewRayMedium<double>&, const LightSource<double>&,
                                         double, ScatteredBy);
extern template float airlight_integral(const ViewRayMedium<float>&, const LightSource<float>&,
                                        float, ScatteredBy);

}  // namespace brume
