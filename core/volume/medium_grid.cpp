#include "core/volume/medium_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <unordered_map>

#include "brume/limits.h"
#include "core/math/max_component.h"
#include "core/medium/gaussian_term.h"

namespace brume {
namespace {

constexpr int side = DensityGrid::side;
constexpr double cutoff_in_radii = 3.035;  // exp(-cutoff_in_radii^2) = 1e-4
constexpr double max_voxels = 1 << 28;     // from the origin, along each axis

struct CornerHash {
  std::size_t operator()(const glm::ivec3& c) const {
    // Three large primes (Teschner et al. 2003).
    const auto term = [](int x, std::size_t prime) {
      return static_cast<std::size_t>(static_cast<std::uint32_t>(x / side)) * prime;
    };
    return term(c.x, 73856093) ^ term(c.y, 19349663) ^ term(c.z, 83492791);
  }
};

// Blocks that a Gaussian touches, its center and its cutoff in voxels.
struct Touched {
  glm::dvec3 center;
  double radius;

  Touched(const Gaussian& g, double voxel_size)
      : center(g.center / voxel_size), radius(cutoff_in_radii * g.radius / voxel_size) {}

  // Calls visit(corner) for each; false if it returns false.
  template <class Visit>
  [[nodiscard]] bool each(Visit visit) const {
    const glm::ivec3 low = block_corner(glm::ivec3(glm::floor(center - radius)));
    const glm::ivec3 high = block_corner(glm::ivec3(glm::ceil(center + radius)));
    for (int x = low.x; x <= high.x; x += side) {
      for (int y = low.y; y <= high.y; y += side) {
        for (int z = low.z; z <= high.z; z += side) {
          const glm::dvec3 first(x, y, z);
          const glm::dvec3 offset = glm::clamp(center, first, first + double(side - 1)) - center;
          if (glm::dot(offset, offset) > radius * radius) continue;
          if (!visit(glm::ivec3(x, y, z))) return false;
        }
      }
    }
    return true;
  }
};

// The same of an ellipsoid: those with voxels in it, found by the columns of voxels that meet it,
// as a thin slanted one has a small part of its box.
class TouchedByEllipsoid {
 public:
  TouchedByEllipsoid(const Gaussian& g, double voxel_size) : ball_(g, voxel_size) {
    const Ellipsoid<double> ellipsoid(g.shape);
    const glm::dmat3 half(ellipsoid.axes[0] * g.shape.stretch[0],
                          ellipsoid.axes[1] * g.shape.stretch[1],
                          ellipsoid.axes[2] * g.shape.stretch[2]);
    // Variances over the square of the greatest radius, and their inverse.
    const glm::dmat3 s = half * glm::transpose(half);
    reach_ = ball_.radius * ellipsoid.reach();
    y_per_x_ = s[0][1] / s[0][0];
    y_reach_ = ball_.radius * std::sqrt(std::max(s[1][1] - y_per_x_ * s[0][1], 0.0));
    form_ = ellipsoid.warp * ellipsoid.warp;
  }

  [[nodiscard]] const glm::dvec3& reach() const { return reach_; }

  template <class Visit>
  [[nodiscard]] bool each(Visit visit) const {
    const auto [first_x, last_x] = voxels(ball_.center.x, reach_.x);
    for (int x = first_block(first_x); x <= last_x; x += side) {
      Range rows;
      for (int i = std::max(x, first_x); i <= std::min(x + side - 1, last_x); ++i) rows.add(row(i));
      for (int y = first_block(rows.first); y <= rows.last; y += side) {
        Range columns;
        for (int i = std::max(x, first_x); i <= std::min(x + side - 1, last_x); ++i) {
          const Range here = row(i);
          for (int j = std::max(y, here.first); j <= std::min(y + side - 1, here.last); ++j) {
            columns.add(column(i, j));
          }
        }
        for (int z = first_block(columns.first); z <= columns.last; z += side) {
          if (!visit(glm::ivec3(x, y, z))) return false;
        }
      }
    }
    return true;
  }

 private:
  // Voxels from first to last; none if that is less.
  struct Range {
    int first = std::numeric_limits<int>::max();
    int last = std::numeric_limits<int>::min();
    void add(const Range& other) {
      if (other.last < other.first) return;
      first = std::min(first, other.first);
      last = std::max(last, other.last);
    }
  };

  static int first_block(int voxel) { return block_corner(glm::ivec3(voxel)).x; }
  static Range voxels(double middle, double half) {
    return {static_cast<int>(std::ceil(middle - half)),
            static_cast<int>(std::floor(middle + half))};
  }
  // The range over all y at x, and over all z at x and y.
  [[nodiscard]] Range row(int x) const {
    const double dx = x - ball_.center.x;
    const double left = 1.0 - dx * dx / (reach_.x * reach_.x);
    return voxels(ball_.center.y + y_per_x_ * dx, y_reach_ * std::sqrt(std::max(left, 0.0)));
  }
  [[nodiscard]] Range column(int x, int y) const {
    const glm::dvec3 q(x - ball_.center.x, y - ball_.center.y, 0.0);
    const double zz = form_[2][2];
    const double middle = -(form_[0][2] * q.x + form_[1][2] * q.y) / zz;
    const double left = ball_.radius * ball_.radius - glm::dot(q, form_ * q) + zz * middle * middle;
    return voxels(ball_.center.z + middle, std::sqrt(std::max(left, 0.0) / zz));
  }

  Touched ball_;
  glm::dvec3 reach_;      // of the box
  double y_per_x_ = 0.0;  // of the middle of a row
  double y_reach_ = 0.0;  // at x = 0
  glm::dmat3 form_;       // q . form q = radius^2 on the surface
};

// Calls visit(corner) for the blocks that a Gaussian touches; false if visit() returns false, or if
// there are too many to count or certainly more than `max_blocks`.
template <class Visit>
bool each_block(const Gaussian& g, double voxel_size, std::size_t max_blocks, Visit visit) {
  const auto fits = [&](const glm::dvec3& reach, const glm::dvec3& radii) {
    const Touched ball(g, voxel_size);
    if (!(max_component(glm::abs(ball.center) + reach) < max_voxels)) return false;
    // A Gaussian has 52% of a box along its own axes.
    const glm::dvec3 across = 2.0 * cutoff_in_radii / voxel_size * radii / double(side);
    return 0.5 * across.x * across.y * across.z <= static_cast<double>(max_blocks);
  };
  if (g.is_ball()) {
    const Touched touched(g, voxel_size);
    return fits(glm::dvec3(touched.radius), glm::dvec3(g.radius)) && touched.each(visit);
  }
  const TouchedByEllipsoid touched(g, voxel_size);
  return fits(touched.reach(), g.radii()) && touched.each(visit);
}

using Sums = std::array<double, DensityGrid::block_size>;

// Adds a Gaussian times each of some factors to the sums of the factor.
template <std::size_t count>
void add(const Gaussian& g, const glm::ivec3& corner, double voxel_size,
         const std::array<double, count>& factors, std::array<Sums, count>& sums) {
  if (!g.is_ball()) {
    const StandaloneTerm term(g);
    for (std::size_t i = 0; i < DensityGrid::block_size; ++i) {
      const auto voxel_index = static_cast<int>(i);
      const glm::ivec3 voxel = corner + glm::ivec3(voxel_index / (side * side),
                                                   voxel_index / side % side, voxel_index % side);
      const glm::dvec3 q = (*term).scaled(voxel_size * glm::dvec3(voxel));
      const double density = g.density * std::exp(-glm::dot(q, q));
      for (std::size_t k = 0; k < count; ++k) sums[k][i] += factors[k] * density;
    }
    return;
  }
  std::array<std::array<double, side>, 3> along;
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < side; ++k) {
      const double t = (voxel_size * (corner[axis] + k) - g.center[axis]) / g.radius;
      along[static_cast<std::size_t>(axis)][static_cast<std::size_t>(k)] = std::exp(-t * t);
    }
  }
  std::size_t i = 0;
  for (const double ex : along[0]) {
    for (const double ey : along[1]) {
      const double e = g.density * ex * ey;
      for (const double ez : along[2]) {
        for (std::size_t k = 0; k < count; ++k) sums[k][i] += factors[k] * (e * ez);
        ++i;
      }
    }
  }
}

}  // namespace

double fitting_voxel_size(const Medium& medium) {
  double min_radius = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (!(medium.densities()[i] > 0.0)) continue;
    const double radius = min_component(medium.gaussian(i).radii());
    if (min_radius == 0.0 || radius < min_radius) min_radius = radius;
  }
  return 0.5 * min_radius;
}

std::optional<MediumSampling> MediumSampling::plan(const Medium& medium, double voxel_size,
                                                   std::size_t max_blocks) {
  MediumSampling result(medium, voxel_size);
  max_blocks /= channels(medium);
  const std::size_t max_pairs = max_blocks * (sizeof(DensityGrid::Block) / sizeof(std::uint32_t));
  std::unordered_map<glm::ivec3, std::size_t, CornerHash> places;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const Gaussian g = medium.gaussian(i);
    if (!(g.density > 0.0)) continue;
    const bool fits = each_block(g, voxel_size, max_blocks, [&](const glm::ivec3& corner) {
      const auto [place, is_new] = places.try_emplace(corner, result.corners_.size());
      if (is_new) {
        if (result.corners_.size() == max_blocks) return false;
        result.corners_.push_back(corner);
        result.gaussians_.emplace_back();
      }
      result.gaussians_[place->second].push_back(static_cast<std::uint32_t>(i));
      return ++result.pairs_ <= max_pairs;
    });
    if (!fits) return std::nullopt;
  }
  return result;
}

template <std::size_t count, class BlockValues>
std::optional<DensityGrid> MediumSampling::sample(const std::array<Factor, count>& factors,
                                                  const std::stop_token& stop,
                                                  const std::function<void(double)>& progress,
                                                  BlockValues block_values) const {
  DensityGrid grid;
  grid.spacing = glm::dvec3(voxel_size_);
  grid.blocks.resize(blocks());
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, blocks(), [&](std::size_t b) {
    if (stop.stop_requested()) return;
    std::array<Sums, count> sums{};
    for (const std::uint32_t i : gaussians_[b]) {
      const Gaussian g = medium_->gaussian(i);
      std::array<double, count> weights;
      for (std::size_t k = 0; k < count; ++k) weights[k] = factors[k](g);
      add(g, corners_[b], voxel_size_, weights, sums);
    }
    DensityGrid::Block& block = grid.blocks[b];
    block.corner = corners_[b];
    for (std::size_t i = 0; i < block.values.size(); ++i) {
      block.values[i] = static_cast<float>(block_values(sums, i));
    }
    const std::size_t so_far = ++done;
    if (progress && so_far % 256 == 0) {
      progress(static_cast<double>(so_far) / static_cast<double>(blocks()));
    }
  });
  if (stop.stop_requested()) return std::nullopt;
  grid.sort();
  return grid;
}

std::optional<DensityGrid> MediumSampling::sample(
    const std::stop_token& stop, const std::function<void(double)>& progress) const {
  const std::array<Factor, 1> one{[](const Gaussian&) { return 1.0; }};
  return sample(one, stop, progress,
                [](const std::array<Sums, 1>& sums, std::size_t i) { return sums[0][i]; });
}

std::optional<VolumeColors> MediumSampling::sample_colors(
    const glm::dvec3& medium_albedo, const std::stop_token& stop,
    const std::function<void(double)>& progress) const {
  const double ratios = static_cast<double>(channels(*medium_)) - 1.0;
  double finished = 0.0;
  const auto ratio = [&](const Factor& numerator, const Factor& denominator) {
    const auto ratio_progress = [&, begin = finished++](double p) {
      if (progress) progress((begin + p) / ratios);
    };
    return sample(std::array{numerator, denominator}, stop, ratio_progress,
                  [](const std::array<Sums, 2>& sums, std::size_t i) {
                    // Where single precision has a density.
                    const bool has_matter = static_cast<float>(sums[1][i]) > 0.0f;
                    return has_matter ? sums[0][i] / sums[1][i] : 0.0;
                  });
  };
  VolumeColors colors;
  if (medium_->has_albedos()) colors.albedo.emplace();
  if (medium_->has_emission()) colors.emission.emplace();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto channel = static_cast<int>(k);
    const Factor extinction = [=](const Gaussian& g) {
      return 1.0 / g.optics.albedo.value_or(medium_albedo)[channel];
    };
    if (colors.albedo) {
      auto grid = ratio([](const Gaussian&) { return 1.0; }, extinction);
      if (!grid) return std::nullopt;
      (*colors.albedo)[k] = std::move(*grid);
    }
    if (colors.emission) {
      auto grid =
          ratio([=](const Gaussian& g) { return g.optics.emission[channel] * extinction(g); },
                extinction);
      if (!grid) return std::nullopt;
      (*colors.emission)[k] = std::move(*grid);
    }
  }
  return colors;
}

std::optional<double> sufficient_voxel_size(const Medium& medium, double voxel_size,
                                            std::size_t max_blocks) {
  for (double size = voxel_size; size <= limits::max_length; size *= 2.0) {
    const double digit = std::pow(10.0, std::floor(std::log10(size)) - 1.0);
    char text[16];
    std::snprintf(text, sizeof text, "%.1e", digit * std::ceil(size / digit * (1.0 - 1e-9)));
    const double rounded = std::strtod(text, nullptr);
    if (MediumSampling::plan(medium, rounded, max_blocks)) return rounded;
  }
  return std::nullopt;
}

}  // namespace brume
