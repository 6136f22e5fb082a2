#include "render/optical_depth/path_depths.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

constexpr std::size_t bundle_size = 32;

// Position of a direction on a space-filling curve: Morton order of the
// octahedral map.
std::uint32_t direction_code(const glm::dvec3& q) {
  const double sum = std::abs(q.x) + std::abs(q.y) + std::abs(q.z);
  if (!(sum > 0.0)) return 0;
  glm::dvec2 p = glm::dvec2(q.x, q.y) / sum;
  if (q.z < 0.0) {
    p = glm::dvec2((1.0 - std::abs(p.y)) * (p.x < 0.0 ? -1.0 : 1.0),
                   (1.0 - std::abs(p.x)) * (p.y < 0.0 ? -1.0 : 1.0));
  }
  const auto spread = [](double x) {
    auto bits = static_cast<std::uint32_t>(std::clamp(0.5 * (x + 1.0) * 65535.0, 0.0, 65535.0));
    bits = (bits | (bits << 8)) & 0x00ff00ffu;
    bits = (bits | (bits << 4)) & 0x0f0f0f0fu;
    bits = (bits | (bits << 2)) & 0x33333333u;
    return (bits | (bits << 1)) & 0x55555555u;
  };
  return spread(p.x) | (spread(p.y) << 1);
}

// Per-thread scratch memory, reused to avoid allocations.
struct PathScratch {
  std::vector<std::uint32_t> candidates;
  GaussianBatch batch;
  PathBatch paths;
  std::vector<float> sums;
};

std::uint64_t plain_depths(const MediumIndex& medium, const glm::dvec3& origin,
                           std::span<const glm::dvec3> ends, std::span<const std::int32_t> self,
                           std::span<const std::uint32_t> candidates, std::span<double> depths) {
  std::uint64_t pairs = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    depths[k] = 0.0;
    const glm::dvec3 q = ends[k] - origin;
    const double length = glm::length(q);
    if (!(length > 0.0)) continue;
    for (const std::uint32_t j : candidates) {
      if (static_cast<std::int32_t>(j) == self[k]) continue;
      const GaussianTerm<double>& g = medium.gaussians()[j];
      depths[k] += optical_depth(g, line_profile(g, origin, q / length), length);
      ++pairs;
    }
  }
  return pairs;
}

}  // namespace

std::uint64_t bundle_depths(const MediumIndex& medium, const glm::dvec3& origin,
                            std::span<const glm::dvec3> ends, std::span<const std::int32_t> self,
                            Settings::Precision precision, std::span<double> depths) {
  thread_local PathScratch scratch;
  scratch.candidates.clear();
  medium.bvh().query(RayBundle(origin, ends),
                     [&](std::uint32_t i) { scratch.candidates.push_back(i); });
  if (precision == Settings::Precision::plain_double) {
    return plain_depths(medium, origin, ends, self, scratch.candidates, depths);
  }
  scratch.batch.assign(medium, origin, scratch.candidates);
  scratch.paths.assign(origin, ends, self);
  scratch.sums.assign(scratch.paths.padded_size(), 0.0f);
  accumulate_path_depths(scratch.batch, scratch.paths, scratch.sums.data());
  std::copy_n(scratch.sums.begin(), ends.size(), depths.begin());
  return scratch.candidates.size() * ends.size();
}

CenterDepths center_depths(const MediumIndex& medium, const glm::dvec3& origin,
                           Settings::Precision precision) {
  struct Target {
    std::uint32_t code;
    std::int32_t gaussian;
  };
  const std::size_t count = medium.size();
  std::vector<Target> order(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    order[i] = {direction_code(medium.gaussians()[i].b - origin), static_cast<std::int32_t>(i)};
  });
  tbb::parallel_sort(order.begin(), order.end(), [](const Target& a, const Target& b) {
    return a.code != b.code ? a.code < b.code : a.gaussian < b.gaussian;
  });

  CenterDepths result;
  result.depths.resize(count);
  std::atomic<std::uint64_t> pairs = 0;
  const std::size_t bundles = (count + bundle_size - 1) / bundle_size;
  tbb::parallel_for(std::size_t{0}, bundles, [&](std::size_t bundle) {
    const std::size_t begin = bundle * bundle_size;
    const std::size_t size = std::min(bundle_size, count - begin);
    std::array<glm::dvec3, bundle_size> ends;
    std::array<std::int32_t, bundle_size> self;
    std::array<double, bundle_size> depths;
    for (std::size_t k = 0; k < size; ++k) {
      self[k] = order[begin + k].gaussian;
      ends[k] = medium.gaussians()[static_cast<std::size_t>(self[k])].b;
    }
    pairs += bundle_depths(medium, origin, std::span(ends).first(size), std::span(self).first(size),
                           precision, std::span(depths).first(size));
    for (std::size_t k = 0; k < size; ++k) {
      result.depths[static_cast<std::size_t>(self[k])] = depths[k];
    }
  });
  result.pairs = pairs;
  return result;
}

CenterDepths parallel_center_depths(const MediumIndex& medium, const glm::dvec3& eye,
                                    const glm::dvec3& direction) {
  CenterDepths result;
  result.depths.resize(medium.size());
  std::atomic<std::uint64_t> pairs = 0;
  tbb::parallel_for(std::size_t{0}, medium.size(), [&](std::size_t i) {
    const glm::dvec3& b = medium.gaussians()[i].b;
    const double length = glm::dot(b - eye, direction);
    if (!(length > 0.0)) return;
    const RaySegment segment{b - length * direction, direction, length};
    std::uint64_t found = 0;
    medium.bvh().query(segment, [&](std::uint32_t j) {
      if (j == i) return;
      const GaussianTerm<double>& g = medium.gaussians()[j];
      result.depths[i] += optical_depth(g, line_profile(g, segment.origin, direction), length);
      ++found;
    });
    pairs += found;
  });
  result.pairs = pairs;
  return result;
}

}  // namespace brume
