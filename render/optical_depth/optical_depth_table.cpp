#include "render/optical_depth/optical_depth_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/math/substantial.h"
#include "render/optical_depth/increment_kernels.h"

namespace brume {
namespace {

// Directions are built in square blocks, whose rays share a list of Gaussians.
constexpr int block_side = 8;

// The map is laid out for the core of each Gaussian; directions farther out get the depth of the
// map's border. The core has core_radii, beyond which the depth is below 0.2% of that through the
// center, or ends where the depth falls below core_depth.
constexpr double core_radii = 2.5;
constexpr double core_depth = 0.02;

}  // namespace

TableGaussian::TableGaussian(const MediumIndex& medium, std::size_t index)
    : center(medium.gaussians()[index].b),
      core(std::min(medium.cutoff_radii()[index],
                    std::max(core_radii / medium.gaussians()[index].a,
                             brume::cutoff_radius(1.0 / medium.gaussians()[index].a,
                                                  medium.gaussians()[index].c, core_depth)))),
      cutoff_radius(medium.cutoff_radii()[index]) {}

TableRadii::TableRadii(int count_, double first_, double last, double half)
    : count(count_), first(first_) {
  const double length = last - first;
  half = std::max(half, 1e-4 * length);  // more than float can take
  if (half < 0.25 * length) curvature = 1.0 / half - 2.0 / length;
  per_unit = (count - 1) * (1.0 + curvature * length) / length;
}

double TableRadii::radius(int k) const {
  return first + k / (per_unit - curvature * k);
}

OpticalDepthTableLayout::OpticalDepthTableLayout(const MediumIndex& medium, const glm::dvec3& light,
                                                 const OpticalDepthTableSize& size) {
  std::vector<TableGaussian> gaussians;
  std::vector<GaussianExtent> extents;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const TableGaussian& g = gaussians.emplace_back(medium, i);
    extents.push_back({g.center - g.cutoff_radius, g.center + g.cutoff_radius,
                       central_depth(medium.gaussians()[i])});
  }
  std::vector<Ball> balls;
  std::vector<double> distances;
  std::vector<double> cutoff_radii;
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (const std::size_t i : substantial_gaussians(extents)) {
    const TableGaussian& g = gaussians[i];
    if (!(g.cutoff_radius > 0.0)) continue;
    balls.push_back({g.center, g.core});
    cutoff_radii.push_back(g.cutoff_radius);
    const double distance = distances.emplace_back(glm::length(g.center - light));
    nearest = std::min(nearest, distance - g.cutoff_radius);
    farthest = std::max(farthest, distance + g.cutoff_radius);
  }
  if (balls.empty()) return;
  // A few Gaussians as large as the world must not leave the others in one cell.
  std::vector<double> sorted = cutoff_radii;
  const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), median, sorted.end());
  double typical_extent = 0.0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (cutoff_radii[k] > 10.0 * *median) continue;
    typical_extent = std::max(typical_extent, distances[k] + cutoff_radii[k]);
  }
  const double first = std::max(nearest, 0.0);
  // Nor all of the light of a point light in dense fog, which does not get far.
  const double density_at_light =
      std::max(medium.density(light) - medium.homogeneous_density_at(light), 1e-30);
  radii =
      TableRadii(size.radii, first, farthest,
                 std::min(typical_extent - first, OpticalDepthTable::opaque / density_at_light));
  map = DirectionMap::towards(light, balls, size.directions);
}

OpticalDepthTable::OpticalDepthTable(const MediumIndex& medium, const glm::dvec3& light,
                                     const OpticalDepthTableSize& size)
    : OpticalDepthTable(medium, light, std::array{glm::dvec3(0.0)}, size) {}

OpticalDepthTable::OpticalDepthTable(const MediumIndex& medium, const glm::dvec3& light,
                                     std::span<const glm::dvec3> parts,
                                     const OpticalDepthTableSize& size)
    : light_(light), layout_(medium, light, size) {
  if (layout_.empty()) return;
  const auto radii = static_cast<std::size_t>(layout_.radii.count);
  std::vector<float> exact(layout_.map.cells() * radii);
  std::atomic<std::uint64_t> all_pairs = 0;
  tbb::parallel_for(0, blocks_across() * blocks_down(), [&](int index) {
    const Block block = block_at(index);
    for (const glm::dvec3& part : parts) {
      all_pairs += find_depths(medium, part, block, [&](std::size_t cell, const float* depths) {
        float* sums = exact.data() + cell * radii;
        for (std::size_t k = 0; k < radii; ++k) {
          sums[k] = parts.size() == 1 ? depths[k] : sums[k] + std::exp(-depths[k]);
        }
      });
    }
    if (parts.size() == 1) return;
    for (const std::size_t cell : block.cells) {
      for (std::size_t k = cell * radii; k < (cell + 1) * radii; ++k) {
        // Rounding may leave more than all of it.
        const float depth = std::log(static_cast<float>(parts.size()) / exact[k]);
        exact[k] = std::clamp(depth, 0.0f, opaque);
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
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, exact.size(), 1 << 16), [&](auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) depths_[i] = stored(exact[i]);
  });
}

int OpticalDepthTable::blocks_across() const {
  return (layout_.map.stride() + block_side - 1) / block_side;
}

int OpticalDepthTable::blocks_down() const {
  return (layout_.map.rows + 2 + block_side - 1) / block_side;
}

OpticalDepthTable::Block OpticalDepthTable::block_at(int index) const {
  Block result;
  const int x0 = index % blocks_across() * block_side;
  const int y0 = index / blocks_across() * block_side;
  for (int y = y0; y < std::min(y0 + block_side, layout_.map.rows + 2); ++y) {
    for (int x = x0; x < std::min(x0 + block_side, layout_.map.stride()); ++x) {
      result.ends.push_back(layout_.radii.last() * layout_.map.direction(x - 1, y - 1));
      result.cells.push_back(static_cast<std::size_t>(y) *
                                 static_cast<std::size_t>(layout_.map.stride()) +
                             static_cast<std::size_t>(x));
    }
  }
  return result;
}

template <class Store>
std::uint64_t OpticalDepthTable::find_depths(const MediumIndex& medium, const glm::dvec3& part,
                                             const Block& block, Store store) const {
  const auto radii = static_cast<std::size_t>(layout_.radii.count);
  std::vector<float> boundaries(radii);
  for (int k = 0; k < layout_.radii.count; ++k) {
    boundaries[static_cast<std::size_t>(k)] = static_cast<float>(layout_.radii.radius(k));
  }
  const glm::dvec3 origin = light_ + part;
  std::vector<glm::dvec3> ends;
  for (const glm::dvec3& end : block.ends) ends.push_back(origin + end);
  std::vector<std::uint32_t> candidates;
  medium.bvh().query(RayBundle(origin, ends), [&](std::uint32_t i) { candidates.push_back(i); });
  GaussianBatch batch;
  batch.assign(medium, origin, candidates);
  PathBatch rays;
  rays.assign(origin, ends, std::vector<std::int32_t>(ends.size(), -1));
  std::vector<float> increments((radii - 1) * rays.padded_size(), 0.0f);
  RaySlices slices;
  slices.assign(boundaries, rays);
  const std::uint64_t evaluated = accumulate_increments(batch, rays, slices, increments.data());
  std::vector<float> depths(radii, 0.0f);
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    for (std::size_t k = 1; k < radii; ++k) {
      depths[k] = depths[k - 1] + increments[(k - 1) * rays.padded_size() + i];
    }
    store(block.cells[i], depths.data());
  }
  return evaluated;
}

std::uint16_t OpticalDepthTable::stored(float depth) const {
  return static_cast<std::uint16_t>(std::min(depth / unit_ + 0.5f, 65535.0f));
}

OpticalDepthTable::View OpticalDepthTable::view() const {
  return {depths_.data(),
          unit_,
          layout_.map,
          layout_.radii.count,
          static_cast<float>(layout_.radii.first),
          static_cast<float>(layout_.radii.per_unit),
          static_cast<float>(layout_.radii.curvature)};
}

}  // namespace brume
