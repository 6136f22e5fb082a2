#include "core/authoring/fog_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/random_source.h"

namespace brume {
namespace {

constexpr double radius_per_spacing = 0.8;
constexpr double scale_heights = 3.0;  // that height fog is filled to: e^-3 is next to nothing

using CellCounts = std::array<int, 3>;

glm::dvec3 filled_size(const FogShape& shape) {
  glm::dvec3 size = shape.size;
  if (shape.kind == FogShape::Kind::height) size.y *= scale_heights;
  return size;
}

CellCounts cells_along(const FogShape& shape) {
  const glm::dvec3 size = filled_size(shape);
  const auto along = [&](int axis) {
    const double spacing = shape.spacing * (axis == 1 ? 1.0 : shape.flatness);
    return static_cast<int>(std::clamp(std::round(size[axis] / spacing), 1.0, 1e6));
  };
  return {along(0), along(1), along(2)};
}

// Gives a Gaussian the density at which one to a cell of this volume makes a mean density.
void set_density(Gaussian& gaussian, double mean, double cell_volume) {
  gaussian.density =
      mean * cell_volume / std::pow(std::sqrt(std::numbers::pi) * gaussian.mean_radius(), 3);
}

// The rotation from y to a unit vector that points up.
glm::dquat rotation_of(const glm::dvec3& up) {
  const glm::dvec3 axis = glm::cross(glm::dvec3(0.0, 1.0, 0.0), up);
  return glm::normalize(glm::dquat(1.0 + up.y, axis.x, axis.y, axis.z));
}

// The ground's normal, as found half a Gaussian to each side.
glm::dvec3 normal_at(const glm::dvec3& x, double step, const FindGround& find_ground) {
  const auto slope = [&](double dx, double dz) {
    const auto before = find_ground(x.x - dx, x.z - dz);
    const auto behind = find_ground(x.x + dx, x.z + dz);
    return before && behind ? (*behind - *before) / (2.0 * step) : 0.0;
  };
  return glm::normalize(glm::dvec3(-slope(step, 0.0), 1.0, -slope(0.0, step)));
}

}  // namespace

double cell_count(const FogShape& shape) {
  const CellCounts n = cells_along(shape);
  return static_cast<double>(n[0]) * n[1] * n[2];
}

std::vector<Gaussian> fill(const FogShape& shape) {
  const CellCounts n = cells_along(shape);
  const glm::dvec3 size = filled_size(shape);
  const glm::dvec3 cell = size / glm::dvec3(n[0], n[1], n[2]);
  const double radius = radius_per_spacing * shape.spacing;
  Gaussian one;
  one.set_radii(radius * glm::dvec3(shape.flatness, 1.0, shape.flatness), one.shape.rotation);
  set_density(one, shape.density, cell.x * cell.y * cell.z);
  const bool is_height = shape.kind == FogShape::Kind::height;
  glm::dvec3 low = shape.center - 0.5 * size;
  if (is_height) low.y = shape.center.y;
  RandomSource random(shape.seed);
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < n[0]; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      for (int k = 0; k < n[2]; ++k) {
        const double x = random.uniform();
        const double y = random.uniform();
        const double z = random.uniform();
        const glm::dvec3 aside = shape.jitter * (glm::dvec3(x, y, z) - 0.5);
        const glm::dvec3 center = low + cell * (glm::dvec3(i, j, k) + 0.5 + aside);
        const glm::dvec3 from_center = (center - shape.center) / (0.5 * size);
        if (shape.kind == FogShape::Kind::sphere && glm::dot(from_center, from_center) > 1.0) {
          continue;
        }
        const double thinned = is_height ? std::exp(-(center.y - low.y) / shape.size.y) : 1.0;
        Gaussian& gaussian = gaussians.emplace_back(one);
        gaussian.center = center;
        gaussian.density *= thinned;
      }
    }
  }
  return gaussians;
}

std::vector<Gaussian> lay_on_ground(const FogShape& shape, const FindGround& find_ground) {
  FogShape layer = shape;
  layer.kind = FogShape::Kind::box;
  layer.size.y = shape.spacing;
  const double radius = radius_per_spacing * shape.spacing;
  std::vector<Gaussian> gaussians;
  for (Gaussian gaussian : fill(layer)) {
    const auto ground = find_ground(gaussian.center.x, gaussian.center.z);
    if (!ground) continue;
    const double lift = gaussian.center.y - shape.center.y;
    gaussian.center.y = *ground + std::max(0.35 * radius + 0.5 * lift, 0.0);
    // The optical depth is that of a layer that thick.
    gaussian.density *= shape.size.y / shape.spacing;
    if (!gaussian.is_ball()) {
      const double step = 0.5 * gaussian.radius;
      gaussian.shape.rotation = rotation_of(normal_at(gaussian.center, step, find_ground));
    }
    gaussians.push_back(gaussian);
  }
  return gaussians;
}

std::vector<Gaussian> rise(const FogColumn& column) {
  RandomSource random(column.seed);
  std::vector<Gaussian> gaussians;
  const auto count = static_cast<double>(column.count);
  for (std::size_t i = 0; i < column.count; ++i) {
    // Closer near the foot, where they are small.
    const double t = std::pow((static_cast<double>(i) + random.uniform()) / count, 1.5);
    const double radius = 0.5 * column.width + 0.5 * column.spread * column.height * t;
    const glm::dvec3 axis =
        column.foot + glm::dvec3(0.0, column.height * t, 0.0) + column.lean * (t * t);
    const glm::dvec3 center = axis + column.turbulence * radius * random.in_ball();
    const double widened = 0.5 * column.width / radius;
    const double varied = 0.6 + 0.8 * random.uniform();
    // Thins less than by its cross-section, as what follows catches up; and away at the top.
    gaussians.push_back(
        {center, radius, column.density * std::pow(widened, 1.3) * varied * (1.0 - t * t)});
  }
  return gaussians;
}

}  // namespace brume
