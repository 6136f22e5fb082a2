#include "tools/fit_report/grid_picture.h"
#include "core/scene/camera_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace brume {
namespace {

// The grid as one array, with an empty voxel around it: quick to look up.
class DenseGrid {
 public:
  explicit DenseGrid(const DensityGrid& grid) : grid_(grid) {
    glm::ivec3 low(std::numeric_limits<int>::max());
    glm::ivec3 high(std::numeric_limits<int>::min());
    for (const DensityGrid::Block& block : grid.blocks) {
      low = glm::min(low, block.corner);
      high = glm::max(high, block.corner + DensityGrid::side);
    }
    low_ = low - 1;
    size_ = high - low + 2;
    values_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                   static_cast<std::size_t>(size_.z));
    for (const DensityGrid::Block& block : grid.blocks) {
      for (std::size_t i = 0; i < DensityGrid::block_size; ++i) {
        const auto n = static_cast<int>(i);
        const glm::ivec3 voxel = block.corner + glm::ivec3(n / 64, n / 8 % 8, n % 8);
        values_[index(voxel - low_)] = block.values[i];
      }
    }
  }

  // The box that has smoke, in voxels from its corner.
  [[nodiscard]] glm::dvec3 extent() const { return glm::dvec3(size_ - 1); }
  [[nodiscard]] glm::dvec3 local(const glm::dvec3& world) const {
    return grid_.to_voxel(world) - glm::dvec3(low_);
  }

  [[nodiscard]] double at(const glm::dvec3& p) const {
    const glm::ivec3 v = glm::clamp(glm::ivec3(glm::floor(p)), glm::ivec3(0), size_ - 2);
    const glm::dvec3 f = glm::clamp(p - glm::dvec3(v), 0.0, 1.0);
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 o(i & 1, i >> 1 & 1, i >> 2);
      const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(o));
      sum += w.x * w.y * w.z * static_cast<double>(values_[index(v + o)]);
    }
    return sum;
  }

 private:
  [[nodiscard]] std::size_t index(const glm::ivec3& v) const {
    return static_cast<std::size_t>((v.x * size_.y + v.y) * size_.z + v.z);
  }

  const DensityGrid& grid_;
  glm::ivec3 low_{0}, size_{0};
  std::vector<float> values_;
};

// Calls visit(point of the world, its density, step [u]) for the middles of equal steps between two
// points of the world, where they are inside the box.
template <class Visit>
void march(const DenseGrid& grid, const glm::dvec3& start, const glm::dvec3& end, Visit visit) {
  const glm::dvec3 a = grid.local(start);
  const glm::dvec3 way = grid.local(end) - a;
  double t_begin = 0.0;
  double t_end = 1.0;
  for (int k = 0; k < 3; ++k) {
    if (way[k] == 0.0) {
      if (a[k] < 0.0 || a[k] > grid.extent()[k]) return;
      continue;
    }
    const double t0 = -a[k] / way[k];
    const double t1 = (grid.extent()[k] - a[k]) / way[k];
    t_begin = std::max(t_begin, std::min(t0, t1));
    t_end = std::min(t_end, std::max(t0, t1));
  }
  if (!(t_end > t_begin)) return;
  const int steps = 1 + static_cast<int>(2.0 * (t_end - t_begin) * glm::length(way));
  const double step = (t_end - t_begin) / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = t_begin + (i + 0.5) * step;
    visit(start + t * (end - start), grid.at(a + t * way), step * glm::length(end - start));
  }
}

double depth_between(const DenseGrid& grid, const glm::dvec3& start, const glm::dvec3& end) {
  double depth = 0.0;
  march(grid, start, end,
        [&](const glm::dvec3&, double density, double step) { depth += density * step; });
  return depth;
}

}  // namespace

std::vector<float> grid_picture(const DensityGrid& grid, const Camera& camera, const Film& film,
                                const Light& light) {
  std::vector<float> picture(static_cast<std::size_t>(film.width) *
                             static_cast<std::size_t>(film.height));
  if (grid.blocks.empty()) return picture;
  const DenseGrid dense(grid);
  const CameraRays rays(camera, film);
  // Beyond all of it.
  const double far = 2.0 * (glm::length(rays.eye() - grid.to_world(glm::dvec3(0.0))) +
                            glm::length(grid.spacing * dense.extent()) + 1.0);
  tbb::parallel_for(0, film.height, [&](int y) {
    for (int x = 0; x < film.width; ++x) {
      const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
      double depth = 0.0;
      double radiance = 0.0;
      march(dense, rays.eye(), rays.eye() + far * w,
            [&](const glm::dvec3& p, double density, double step) {
              if (!(density > 0.0)) return;
              const glm::dvec3 to_light = light.position - p;
              const double lit = light.intensity.x / glm::dot(to_light, to_light) *
                                 std::exp(-depth_between(dense, p, light.position));
              radiance += std::exp(-(depth + 0.5 * density * step)) * density * step * lit;
              depth += density * step;
            });
      picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
              static_cast<std::size_t>(x)] =
          static_cast<float>(radiance * std::numbers::inv_pi / 4.0);
    }
  });
  return picture;
}

}  // namespace brume
