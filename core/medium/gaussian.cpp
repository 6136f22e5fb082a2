#include "brume/gaussian.h"

#include <ImathMatrix.h>
#include <ImathMatrixAlgo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "brume/limits.h"
#include "core/math/max_component.h"

namespace brume {
namespace {

// Singular vectors come by size: in the order and the directions of the axes that became them.
void keep_order(const glm::dmat3& images, glm::dmat3& axes, glm::dvec3& sizes) {
  const auto cosine = [&](int image, int axis) {
    return glm::dot(glm::normalize(images[image]), axes[axis]);
  };
  std::array<int, 3> order{0, 1, 2};
  std::array<int, 3> best = order;
  double best_sum = 0.0;
  do {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += std::abs(cosine(k, order[static_cast<std::size_t>(k)]));
    if (sum > best_sum) best = order;
    best_sum = std::max(sum, best_sum);
  } while (std::ranges::next_permutation(order).found);
  const glm::dmat3 unordered = axes;
  const glm::dvec3 unordered_sizes = sizes;
  for (int k = 0; k < 3; ++k) {
    const int from = best[static_cast<std::size_t>(k)];
    axes[k] = unordered[from];
    sizes[k] = unordered_sizes[from];
  }
  for (int k = 0; k < 3; ++k) {
    if (cosine(k, k) < 0.0) axes[k] = -axes[k];
  }
}

}  // namespace

double Gaussian::mean_radius() const {
  const glm::dvec3& s = shape.stretch;
  return is_ball() ? radius : radius * std::cbrt(s.x * s.y * s.z);
}

void Gaussian::set_radii(const glm::dvec3& radii, const glm::dquat& rotation) {
  radius = max_component(radii);
  if (radii == glm::dvec3(radius)) {
    shape = {};  // not before: `rotation` may be that of the shape
    return;
  }
  shape.stretch = glm::max(radii / radius, limits::min_stretch);
  shape.rotation = rotation;
}

glm::dmat3 warp(const GaussianShape& shape) {
  const glm::dmat3 axes = glm::mat3_cast(shape.rotation);
  glm::dmat3 scaled = axes;
  for (int k = 0; k < 3; ++k) scaled[k] /= shape.stretch[k];
  return scaled * glm::transpose(axes);
}

void transform(Gaussian& gaussian, const glm::dmat3& map) {
  // A ball of radius 1 becomes A A^T, A = map R diag(stretch): by the singular values of A, which
  // keep thin ones that its square would lose.
  glm::dmat3 a = map * glm::mat3_cast(gaussian.shape.rotation);
  for (int k = 0; k < 3; ++k) a[k] *= gaussian.shape.stretch[k];
  Imath::M33d matrix, u, v;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix[row][column] = a[column][row];
  }
  Imath::V3d values;
  Imath::jacobiSVD(matrix, u, values, v, 1e-15, true);
  glm::dmat3 axes;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) axes[column][row] = u[row][column];
  }
  glm::dvec3 sizes = glm::abs(glm::dvec3(values.x, values.y, values.z));
  keep_order(a, axes, sizes);
  // A mirrored frame is the same ellipsoid.
  if (glm::determinant(axes) < 0.0) axes[2] = -axes[2];
  const bool is_uniform =
      max_component(sizes) - min_component(sizes) <= 1e-14 * max_component(sizes);
  const glm::dvec3 radii = gaussian.radius * (is_uniform ? glm::dvec3(sizes.x) : sizes);
  gaussian.set_radii(radii, glm::normalize(glm::quat_cast(axes)));
}

}  // namespace brume
