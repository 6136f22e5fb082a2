#include "render/cpu/light_table.h"

#include <tbb/blocked_range.h>
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

// The map is laid out for this much of each Gaussian; what lies further out, below 0.2% of its
// peak, gets the depth of the map's border.
constexpr double core_radii = 2.5;

}  // namespace

LightTable::LightTable(const MediumIndex& medium, const glm::dvec3& light,
                       const LightTableSize& size)
    : light_(light), radii_(size.radii) {
  std::vector<Ball> balls;
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (!(medium.reach()[i] > 0.0)) continue;
    const GaussianTerm<double>& g = medium.gaussians()[i];
    balls.push_back({g.b, std::min(medium.reach()[i], core_radii / g.a)});
    const double distance = glm::length(g.b - light);
    nearest = std::min(nearest, distance - medium.reach()[i]);
    farthest = std::max(farthest, distance + medium.reach()[i]);
  }
  if (balls.empty()) return;
  first_radius_ = std::max(nearest, 0.0);
  last_radius_ = farthest;
  map_ = DirectionMap::towards(light, balls, size.directions);

  const auto radii = static_cast<std::size_t>(size.radii);
  std::vector<float> exact(map_.cells() * radii);
  std::vector<float> boundaries(radii);
  for (std::size_t k = 0; k < radii; ++k) {
    boundaries[k] =
        static_cast<float>(first_radius_ + (last_radius_ - first_radius_) * static_cast<double>(k) /
                                               static_cast<double>(radii - 1));
  }
  const int columns = map_.stride();
  const int rows = map_.rows + 2;
  const int blocks_across = (columns + block - 1) / block;
  const int blocks_down = (rows + block - 1) / block;
  std::atomic<std::uint64_t> all_pairs = 0;
  tbb::parallel_for(0, blocks_across * blocks_down, [&](int at) {
    const int x0 = at % blocks_across * block;
    const int y0 = at / blocks_across * block;
    std::vector<glm::dvec3> ends;
    std::vector<std::size_t> cells;
    for (int y = y0; y < std::min(y0 + block, rows); ++y) {
      for (int x = x0; x < std::min(x0 + block, columns); ++x) {
        ends.push_back(light_ + last_radius_ * map_.direction(x - 1, y - 1));
        cells.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
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
      float* depth = exact.data() + cells[i] * radii;
      for (std::size_t k = 1; k < radii; ++k) {
        depth[k] = depth[k - 1] + increments[(k - 1) * rays.padded_size() + i];
      }
    }
  });
  pairs = all_pairs;

  float deepest = 0.0f;
  for (std::size_t i = radii - 1; i < exact.size(); i += radii) {
    deepest = std::max(deepest, exact[i]);
  }
  unit_ = std::max(std::min(deepest, opaque), 1e-30f) / 65535.0f;
  depths_.resize(exact.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, exact.size(), 1 << 16), [&](auto& part) {
    const float scale = 1.0f / unit_;
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      depths_[i] = static_cast<std::uint16_t>(std::min(exact[i] * scale + 0.5f, 65535.0f));
    }
  });
}

LightTable::View LightTable::view() const {
  return {depths_.data(),
          unit_,
          map_,
          radii_,
          static_cast<float>(first_radius_),
          static_cast<float>((radii_ - 1) / (last_radius_ - first_radius_))};
}

}  // namespace brume
