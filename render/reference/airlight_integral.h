#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/medium/noise.h"
#include "core/transport/light_path.h"
#include "render/reference/gaussian_sums.h"

namespace brume {

// The single-scattering integral (eq. 4 of the paper) along one view ray, converged: the truth
// that every approximation is held against. Exact optical depths, adaptive quadrature in the
// equi-angular variable, intervals placed by the Gaussians that matter on the ray.

// The medium as a view ray [0, d] from eye along the unit vector w meets it.
template <class Real>
class ViewRayMedium {
 public:
  // `gaussians`: all that reach the ray (others only cost time). d may be +inf. `noise` bends the
  // ray, and so whatever is asked for here.
  ViewRayMedium(std::span<const GaussianTerm<Real>> gaussians, Real b0, const Vec3<Real>& eye,
                const Vec3<Real>& w, Real d, const RayNoise& noise = {});

  // At t: the scattering coefficient of the Gaussians alone [1/u], and T(v, x(t)) with b0.
  // t may be +inf.
  [[nodiscard]] typename Crossings<Real>::Sums at(Real t) const;
  [[nodiscard]] Real depth(Real t) const { return at(t).depth; }

  // The least t with depth(t) >= `level`, or d if there is none.
  [[nodiscard]] Real parameter_at_depth(Real level) const;

  // A stretch of the ray where one Gaussian matters, and the longest interval that a 15-point
  // rule integrates well there.
  struct Feature {
    Real begin, end, longest;
  };
  [[nodiscard]] std::span<const Feature> features() const { return features_; }

  const Vec3<Real> eye, w;
  const Real d;
  const Real b0;

 private:
  Crossings<Real> crossings_;
  std::vector<Feature> features_;
};

enum class ScatteredBy { everything, gaussians, homogeneous };

template <class Real>
struct LightSource {
  Vec3<Real> position;
  Real h_min;  // least distance of the light from a ray, see LightPath
  // All that reach the triangle between the light and the ray.
  std::span<const GaussianTerm<Real>> gaussians;
  Real anisotropy;  // of the medium, see henyey_greenstein()
  // The parts [t0, t1] of the ray that see the light past the surfaces; nullopt: all of it.
  std::optional<std::vector<std::pair<Real, Real>>> lit;
};

// Radiance scattered once towards the eye, per unit of the light's radiant intensity [1/u^2]:
//   1 / (4 pi) * integral over [0, d] of b(t) / r(t)^2 exp(-T(v, x) - T(s, x)) dt,
// with b only from the part of the medium that is asked for. `tolerance` is the relative error
// at which the quadrature stops by its own estimate.
template <class Real>
Real airlight_integral(const ViewRayMedium<Real>& medium, const LightSource<Real>& light,
                       Real tolerance, ScatteredBy part = ScatteredBy::everything);

extern template class ViewRayMedium<double>;
extern template class ViewRayMedium<float>;
extern template double airlight_integral(const ViewRayMedium<double>&, const LightSource<double>&,
                                         double, ScatteredBy);
extern template float airlight_integral(const ViewRayMedium<float>&, const LightSource<float>&,
                                        float, ScatteredBy);

}  // namespace brume
