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

// Gaussians in the symbols of the paper, for formulas, in double and float.

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
  // R diag(stretch^2) R^T times a vector: the inverse of the square of `warp`.
  [[nodiscard]] Vec3<Real> squared(const Vec3<Real>& v) const {
    return axes * (stretch * stretch * (v * axes));
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
// Optical depth along a line through the center, in the mean over the shape.
double central_depth(const GaussianTerm<double>& term);

// The Gaussian of a term.
Gaussian gaussian_of(const GaussianTerm<double>& term);

extern template class GaussianTerms<double>;
extern template class GaussianTerms<float>;

}  // namespace brume
