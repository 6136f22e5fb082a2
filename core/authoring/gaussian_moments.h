#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "brume/gaussian.h"

namespace brume {

// A Gaussian by its mass, mean and covariance; of several, those of their sum.
struct GaussianMoments {
  double mass = 0.0;  // the integral of its density, or of its optical depth over a plane [u^2]
  glm::dvec3 center{0.0};
  glm::dmat3 covariance{0.0};  // [u^2]

  explicit GaussianMoments(const Gaussian& gaussian);
  GaussianMoments(const GaussianMoments& a, const GaussianMoments& b);

  // With the same mean variance in all directions.
  void make_round();
  // Gives a Gaussian this mass, mean and covariance; elongations beyond the limit are cut off.
  void apply_to(Gaussian& gaussian) const;
};

// The squared error of optical depth when `one` stands for a and b, integrated over parallel lines
// and averaged over their direction [u^2]. Of the product of two depths this is
//   m_a m_b / (4 pi) * integral of det(M)^(-1/2) exp(-t d^T M^-1 d / 2) dt over t >= 0,
// M = I + t (S_a + S_b), for the masses m, covariances S and distance d: twice average_depth() of a
// Gaussian of mass 1 and the covariance S_a + S_b. Relative error at most 1%.
double squared_error(const GaussianMoments& a, const GaussianMoments& b,
                     const GaussianMoments& one);

}  // namespace brume
