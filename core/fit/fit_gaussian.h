#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "brume/density_grid.h"
#include "brume/fit.h"
#include "brume/gaussian.h"

namespace brume {

// A Gaussian c exp(-|a shape (p - b)|^2) in the grid's own axes, p = spacing * voxel [u].
struct FitGaussian {
  glm::dvec3 b{0.0};
  double a = 1.0;         // of the ball of its volume [1/u]
  double c = 0.0;         // [1/u], > 0
  glm::dmat3 shape{1.0};  // of determinant 1; of a ball the identity

  [[nodiscard]] double integral() const;  // [u^2]
};

// Gaussians of the world in a grid's own axes, and back.
std::vector<FitGaussian> to_fit_gaussians(const DensityGrid& grid,
                                          std::span<const Gaussian> gaussians);
Gaussian to_gaussian(const DensityGrid& grid, const FitGaussian& gaussian);

// Ellipsoid if one is.
FitShape shape_of(std::span<const Gaussian> gaussians);

// A dimensionless step of one Gaussian: m db (three components), d log c, and of a ball d log a; of
// an ellipsoid dm m^-1, which is symmetric: xx, yy, zz, xy, xz, yz; for m = a shape.
using FitStep = std::array<double, 10>;
glm::dmat3 matrix_change(const FitStep& step);

// The Gaussian after a step, each of whose numbers is cut off at 0.7.
FitGaussian moved(const FitGaussian& gaussian, const FitStep& step, FitShape shape);

// A longer one is a needle or a sheet that hides how it was found.
inline constexpr double max_fitted_elongation = 8.0;

// Limits that keep Gaussians where the grid knows of them.
struct FitLimits {
  double min_radius = 0.0;  // along each axis [u]
  double max_radius = std::numeric_limits<double>::infinity();
  // Bounds of centers.
  glm::dvec3 low{-std::numeric_limits<double>::infinity()};
  glm::dvec3 high{std::numeric_limits<double>::infinity()};
};

// Puts the Gaussian within limits; rows of its shape are along its own axes then. Returns along
// which it is as narrow as it may be.
std::array<bool, 3> limit(FitGaussian& gaussian, const FitLimits& limits);

}  // namespace brume
