#include "core/medium/gaussian_term.h"

#include <cmath>
#include <numbers>

#include "core/math/max_component.h"

namespace brume {

template <class Real>
GaussianTerms<Real>::GaussianTerms(const Medium& medium, double factor) {
  reserve(medium.size());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    Gaussian g = medium.gaussian(i);
    g.density *= factor;
    add(g);
  }
}

template <class Real>
void GaussianTerms<Real>::add(const Gaussian& g) {
  const Ellipsoid<Real>* ellipsoid = nullptr;
  if (!g.is_ball()) ellipsoid = &ellipsoids_.emplace_back(g.shape);
  terms_.emplace_back(Real(1.0 / g.radius), Real(g.density), Vec3<Real>(g.center), ellipsoid);
}

StandaloneTerm::StandaloneTerm(const Gaussian& g) {
  if (!g.is_ball()) ellipsoid_.emplace(g.shape);
  term_ = {1.0 / g.radius, g.density, g.center, ellipsoid_ ? &*ellipsoid_ : nullptr};
}

double central_depth(const GaussianTerm<double>& term) {
  return term.c * mean_radius_of(term) * std::sqrt(std::numbers::pi);
}

double mean_radius_of(const GaussianTerm<double>& term) {
  if (!term.ellipsoid) return 1.0 / term.a;
  const glm::dvec3& s = term.ellipsoid->stretch;
  return std::cbrt(s.x * s.y * s.z) / term.a;
}

double min_radius_of(const GaussianTerm<double>& term) {
  return (term.ellipsoid ? min_component(term.ellipsoid->stretch) : 1.0) / term.a;
}

double volume_of(const GaussianTerm<double>& term) {
  return std::pow(std::sqrt(std::numbers::pi) * mean_radius_of(term), 3);
}

Gaussian gaussian_of(const GaussianTerm<double>& term) {
  Gaussian g{term.b, 1.0 / term.a, term.c};
  if (term.ellipsoid) g.shape = {term.ellipsoid->stretch, glm::quat_cast(term.ellipsoid->axes)};
  return g;
}

template class GaussianTerms<double>;
template class GaussianTerms<float>;

}  // namespace brume
