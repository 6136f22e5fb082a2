#pragma once

#include <cstddef>
#include <deque>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brume/gaussian.h"
#include "brume/medium.h"

namespace brume {

// The line integral of a Gaussian c exp(-a^2 |x - b|^2) (eq. 31 of the paper), in double and float,
// with relative accuracy in the tails and for short segments. That of an ellipsoid is the same in
// the space in which it is a ball, W (x - b): a line of direction w passes it as fast as |W w|.

template <class Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;

// The shape of an ellipsoid.
template <class Real>
struct Ellipsoid {
  using Matrix = glm::mat<3, 3, Real, glm::defaultp>;

  Matrix warp;         // see warp()
  Matrix axes;         // its own, as columns
  Vec3<Real> stretch;  // along them

  explicit Ellipsoid(const GaussianShape& shape)
      : warp(brume::warp(shape)), axes(glm::mat3_cast(shape.rotation)), stretch(shape.stretch) {}

  // How far it reaches from its center along a unit direction, over its greatest radius.
  [[nodiscard]] Real reach(const Vec3<Real>& direction) const {
    return glm::length(stretch * (direction * axes));
  }
  // The same along each axis of the scene.
  [[nodiscard]] Vec3<Real> reach() const {
    return {reach({1, 0, 0}), reach({0, 1, 0}), reach({0, 0, 1})};
  }
};

// A Gaussian in the paper's symbols: a = 1 / radius [1/u], c = density [1/u], center b [u].
template <class Real>
struct GaussianTerm {
  Real a = 1;
  Real c = 0;
  Vec3<Real> b{0};
  // Null: a ball. Of an ellipsoid a is that of its greatest radius.
  const Ellipsoid<Real>* ellipsoid = nullptr;

  GaussianTerm() = default;
  GaussianTerm(Real a_, Real c_, const Vec3<Real>& b_, const Ellipsoid<Real>* ellipsoid_ = nullptr)
      : a(a_), c(c_), b(b_), ellipsoid(ellipsoid_) {}

  // Its exponent at a point is minus the square of this vector's length.
  [[nodiscard]] Vec3<Real> scaled(const Vec3<Real>& x) const {
    const Vec3<Real> q = a * (x - b);
    return ellipsoid ? ellipsoid->warp * q : q;
  }
};

// Gaussians in the paper's symbols, with the shapes that the terms of ellipsoids point to.
template <class Real>
class GaussianTerms {
 public:
  GaussianTerms() = default;
  // Those of a medium, their densities times `factor`.
  explicit GaussianTerms(const Medium& medium, double factor = 1.0);
  GaussianTerms(GaussianTerms&&) noexcept = default;
  GaussianTerms& operator=(GaussianTerms&&) noexcept = default;

  void reserve(std::size_t count) { terms_.reserve(count); }
  void add(const Gaussian& gaussian);
  // `lasting`: its shape outlives this.
  void add(const GaussianTerm<Real>& lasting) { terms_.push_back(lasting); }

  [[nodiscard]] std::size_t size() const { return terms_.size(); }
  [[nodiscard]] const GaussianTerm<Real>& operator[](std::size_t i) const { return terms_[i]; }
  [[nodiscard]] std::span<const GaussianTerm<Real>> all() const& { return terms_; }
  void all() const&& = delete;
  [[nodiscard]] bool has_ellipsoids() const { return !ellipsoids_.empty(); }

 private:
  std::vector<GaussianTerm<Real>> terms_;
  std::deque<Ellipsoid<Real>> ellipsoids_;  // does not move what it has
};

// The same of one.
class StandaloneTerm {
 public:
  explicit StandaloneTerm(const Gaussian& gaussian);
  StandaloneTerm(const StandaloneTerm&) = delete;
  StandaloneTerm& operator=(const StandaloneTerm&) = delete;
  ~StandaloneTerm() = default;

  [[nodiscard]] const GaussianTerm<double>& operator*() const { return term_; }

 private:
  std::optional<Ellipsoid<double>> ellipsoid_;
  GaussianTerm<double> term_;
};

// The integral of exp(-|scaled(x)|^2) over space [u^3].
double volume_of(const GaussianTerm<double>& term);

// Gaussian::mean_radius() of a term, and the smallest of its radii.
double mean_radius_of(const GaussianTerm<double>& term);
double min_radius_of(const GaussianTerm<double>& term);

// The Gaussian of a term.
Gaussian gaussian_of(const GaussianTerm<double>& term);

// A Gaussian relative to a line.
template <class Real>
struct LineProfile {
  Real t0;  // parameter of the point of greatest density
  Real e;   // minus the exponent there; of a ball a^2 h^2 for the distance h of the line from the
            // center, computed from the perpendicular vector to avoid cancellation
  Real a;   // the density on the line is c exp(-(e + a^2 (t - t0)^2))
};

// `w`: unit up to rounding.
template <class Real>
LineProfile<Real> line_profile(const GaussianTerm<Real>& g, const Vec3<Real>& origin,
                               const Vec3<Real>& w);

// T over t in [0, d], d >= 0 or +inf.
template <class Real>
Real optical_depth(const GaussianTerm<Real>& g, const LineProfile<Real>& line, Real d);

// T_i(A, B): optical depth between two points; 0 if they coincide.
template <class Real>
Real optical_depth(const GaussianTerm<Real>& g, const Vec3<Real>& A, const Vec3<Real>& B);
double optical_depth(const Gaussian& g, const glm::dvec3& A, const glm::dvec3& B);

// Density-weighted mean parameter of the Gaussian on [0, d].
template <class Real>
Real truncated_mean(const LineProfile<Real>& line, Real d);

// Cutoff radius: any segment farther from the center has an optical depth below eps (rigorous). 0:
// below eps everywhere. Of an ellipsoid that of its greatest radius.
double cutoff_radius(double radius, double density, double eps);

// Half angle [radians] of the cone around o -> center that contains every ray from o within
// `cutoff_radius` of the center; pi if o is within it.
double cutoff_cone(const glm::dvec3& center, double cutoff_radius, const glm::dvec3& o);

#define BRUME_OPTICAL_DEPTH(Real)                                                                \
  extern template class GaussianTerms<Real>;                                                     \
  extern template LineProfile<Real> line_profile(const GaussianTerm<Real>&, const Vec3<Real>&,   \
                                                 const Vec3<Real>&);                             \
  extern template Real optical_depth(const GaussianTerm<Real>&, const LineProfile<Real>&, Real); \
  extern template Real optical_depth(const GaussianTerm<Real>&, const Vec3<Real>&,               \
                                     const Vec3<Real>&);                                         \
  extern template Real truncated_mean(const LineProfile<Real>&, Real);
BRUME_OPTICAL_DEPTH(double)
BRUME_OPTICAL_DEPTH(float)
#undef BRUME_OPTICAL_DEPTH

}  // namespace brume
