#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "brume/density_grid.h"
#include "core/fit/fit_gaussian.h"

namespace brume {

// An ellipsoid, c exp(-|t|^2) for t = a shape (p - b), in a block of 8 x 8 x 8 points. Values and
// weights have z fastest. Rows of points along z that are beyond `cutoff`, in |t|, are left out.
class EllipsoidBlock {
 public:
  // The block's first point and the way from one to the next [u].
  EllipsoidBlock(const FitGaussian& gaussian, const glm::dvec3& first, const glm::dvec3& spacing,
                 double cutoff);

  // False: none of its points is within the cutoff, nor of those half a voxel further.
  [[nodiscard]] bool is_reached() const;

  // values[point] += c exp(-|t|^2)
  void add_gaussian(float c, float* values) const;

  // values[point] += c exp(-|t|^2) (constant + linear . t + t . quadratic t)
  struct Polynomial {
    float constant = 0.0f;
    glm::vec3 linear{0.0f};
    glm::mat3 quadratic{0.0f};  // symmetric
  };
  void add_polynomial(float c, const Polynomial& polynomial, float* values) const;

  // Sums over points of factor * weights * exp(-|t|^2) times 1, t and t t^T.
  struct Moments {
    double one = 0.0;
    glm::dvec3 first{0.0};
    glm::dmat3 second{0.0};
  };
  void add_moments(float factor, const float* weights, Moments& sum) const;

 private:
  static constexpr int side = DensityGrid::side;
  using Row = std::array<float, side>;

  template <class Visit>
  void each_row(Visit visit) const;
  [[nodiscard]] Row exponentials(const glm::vec3& t) const;

  glm::vec3 first_;                        // t of the first point
  glm::vec3 along_x_, along_y_, along_z_;  // from one to the next
  float cutoff_square_;
};

}  // namespace brume
