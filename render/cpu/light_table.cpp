#include "render/cpu/light_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/cpu/slice_kernels.h"

namespace brume {
namespace {

// Directions are built in square blocks, whose rays share a list of Gaussians.
constexpr int block = 8;

}  // namespace

LightTable::LightTable(const MediumIndex& medium, const glm::dvec3& light,
                       const LightTableSize& size)
    : light_(light), radii_(size.radii) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (!(medium.reach()[i] > 0.0)) continue;
    low = glm::min(low, medium.gaussians()[i].b - medium.reach()[i]);
    high = glm::max(high, medium.gaussians()[i].b + medium.reach()[i]);
  }
  if (!(low.x <= high.x)) return;
  const glm::dvec3 middle = 0.5 * (low + high);
  double radius = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (!(medium.reach()[i] > 0.0)) continue;
    radius = std::max(radius, glm::length(medium.gaussians()[i].b - middle) + medium.reach()[i]);
  }
  const double distance = glm::length(middle - light);
  first_radius_ = std::max(distance - radius, 0.0);
  last_radius_ = distance + radius;
  map_ = DirectionMap::towards(light, middle, radius, size.directions);

  const int row = map_.row();
  const auto radii = static_cast<std::size_t>(size.radii);
  depths_.assign(static_cast<std::size_t>(row) * static_cast<std::size_t>(row) * radii, 0.0f);
  std::vector<float> boundaries(radii);
  for (std::size_t k = 0; k < radii; ++k) {
    boundaries[k] =
        static_cast<float>(first_radius_ + (last_radius_ - first_radius_) * static_cast<double>(k) /
                                               static_cast<double>(radii - 1));
  }
  const int blocks = (row + block - 1) / block;
  std::atomic<std::uint64_t> all_pairs = 0;
  tbb::parallel_for(0, blocks * blocks, [&](int at) {
    std::vector<glm::dvec3> ends;
    std::vector<std::size_t> cells;
    for (int y = at / blocks * block; y < std::min((at / blocks + 1) * block, row); ++y) {
      for (int x = at % blocks * block; x < std::min((at % blocks + 1) * block, row); ++x) {
        ends.push_back(light_ + last_radius_ * map_.direction(x - 1, y - 1));
        cells.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(row) +
                        static_cast<std::size_t>(x));
      }
    }
    std::vector<std::uint32_t> candidates;
    medium.hierarchy().query(RayBundle(light_, ends),
                             [&](std::uint32_t i) { candidates.push_back(i); });
    GaussianBatch batch;
    batch.assign(medium, light_, candidates);
    PathBatch rays;
    rays.assign(light_, ends, std::vector<std::int32_t>(ends.size(), -1));
    std::vector<float> increments((radii - 1) * rays.padded_size(), 0.0f);
    all_pairs += accumulate_increments(batch, rays, boundaries, increments.data());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      float* depth = depths_.data() + cells[i] * radii;
      for (std::size_t k = 1; k < radii; ++k) {
        depth[k] = depth[k - 1] + increments[(k - 1) * rays.padded_size() + i];
      }
    }
  });
  pairs = all_pairs;
}

LightTable::View LightTable::view() const {
  return {depths_.data(), map_, radii_, static_cast<float>(first_radius_),
          static_cast<float>((radii_ - 1) / (last_radius_ - first_radius_))};
}

}  // namespace brume
