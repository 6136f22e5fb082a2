#include "core/fit/fit_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <queue>
#include <span>

#include "core/fit/fit_problem.h"
#include "core/medium/gaussian_covariance.h"

namespace brume {
namespace {

struct Sample {
  glm::dvec3 p;   // [u]
  double weight;  // density
};

struct SampleGroup {
  std::span<Sample> samples;
  double weight = 0.0;
  glm::dvec3 mean{0.0};
  glm::dmat3 inertia{0.0};  // sum of weight d d^T

  explicit SampleGroup(std::span<Sample> of) : samples(of) {
    for (const Sample& s : samples) {
      weight += s.weight;
      mean += s.weight * s.p;
    }
    mean /= weight;
    for (const Sample& s : samples) {
      const glm::dvec3 d = s.p - mean;
      inertia += s.weight * glm::outerProduct(d, d);
    }
  }
  [[nodiscard]] double trace() const { return inertia[0][0] + inertia[1][1] + inertia[2][2]; }
  bool operator<(const SampleGroup& other) const { return trace() < other.trace(); }
};

// The direction of the greatest inertia, by power iteration; near enough for a cut.
glm::dvec3 longest_axis(const glm::dmat3& inertia) {
  glm::dvec3 axis(1.0, 0.7, 0.4);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 next = inertia * axis;
    const double length = glm::length(next);
    if (!(length > 0.0)) return {1.0, 0.0, 0.0};
    axis = next / length;
  }
  return axis;
}

// Sorts the group's samples and cuts at half its weight, between voxels.
std::array<std::span<Sample>, 2> cut(const SampleGroup& group) {
  const glm::dvec3 axis = longest_axis(group.inertia);
  std::sort(group.samples.begin(), group.samples.end(), [&](const Sample& a, const Sample& b) {
    return glm::dot(a.p, axis) < glm::dot(b.p, axis);
  });
  double weight = 0.0;
  std::size_t count = 0;
  while (count + 1 < group.samples.size() && weight < 0.5 * group.weight) {
    weight += group.samples[count++].weight;
  }
  count = std::max<std::size_t>(count, 1);
  return {group.samples.first(count), group.samples.subspan(count)};
}

}  // namespace

std::vector<FitGaussian> split_into_gaussians(const DensityGrid& grid, std::size_t count,
                                              FitShape shape, const std::stop_token& stop) {
  std::vector<Sample> samples;
  for (const DensityGrid::Block& block : grid.blocks) {
    std::size_t i = 0;
    for (int x = 0; x < DensityGrid::side; ++x) {
      for (int y = 0; y < DensityGrid::side; ++y) {
        for (int z = 0; z < DensityGrid::side; ++z) {
          const auto value = static_cast<double>(block.values[i++]);
          if (!(value > 0.0)) continue;
          samples.push_back({grid.spacing * glm::dvec3(block.corner + glm::ivec3(x, y, z)), value});
        }
      }
    }
  }
  if (samples.empty() || count == 0) return {};

  std::priority_queue<SampleGroup> groups;
  std::vector<SampleGroup> single;  // groups of one voxel
  groups.emplace(std::span(samples));
  while (groups.size() + single.size() < count && !groups.empty() && !stop.stop_requested()) {
    const SampleGroup group = groups.top();
    groups.pop();
    if (group.samples.size() < 2) {
      single.push_back(group);
      continue;
    }
    for (const std::span<Sample> half : cut(group)) groups.emplace(half);
  }

  const double voxel_variance =
      glm::dot(grid.spacing, grid.spacing) / 12.0;  // a voxel is a little box
  const FitLimits limits = FitProblem::limits(grid, shape);
  std::vector<FitGaussian> gaussians;
  const auto add = [&](const SampleGroup& group) {
    FitGaussian g;
    g.b = group.mean;
    const double variance = (group.trace() / group.weight + voxel_variance) / 3.0;
    g.a = 1.0 / std::max(std::sqrt(2.0 * variance), limits.min_radius);
    if (shape == FitShape::ellipsoid) {
      glm::dmat3 covariance = group.inertia / group.weight;
      for (int k = 0; k < 3; ++k) covariance[k][k] += grid.spacing[k] * grid.spacing[k] / 12.0;
      Gaussian ellipsoid;
      set_covariance(ellipsoid, covariance);
      g.a = 1.0 / ellipsoid.mean_radius();
      g.shape = ellipsoid.mean_radius() / ellipsoid.radius * warp(ellipsoid.shape);
      limit(g, limits);
    }
    g.c = group.weight * grid.voxel_volume() * std::pow(g.a, 3.0) / std::pow(std::numbers::pi, 1.5);
    gaussians.push_back(g);
  };
  for (const SampleGroup& group : single) add(group);
  for (; !groups.empty(); groups.pop()) add(groups.top());
  return gaussians;
}

std::vector<Gaussian> next_start(const DensityGrid& next, std::span<const Gaussian> gaussians,
                                 const VelocityGrid& velocity, double seconds) {
  FitProblem problem(next, shape_of(gaussians));
  std::vector<float> residuals(problem.size());
  const auto squares = [&](std::span<const Gaussian> moved) {
    problem.set(to_fit_gaussians(next, moved));
    return problem.residuals(residuals).all;
  };
  std::vector<Gaussian> best(gaussians.begin(), gaussians.end());
  double min_squares = squares(best);
  for (int halves = 0; halves <= 10; ++halves) {
    std::vector<Gaussian> moved =
        advected(gaussians, velocity, seconds * std::pow(0.5, 0.5 * halves));
    const double found = squares(moved);
    if (!(found < min_squares)) continue;
    min_squares = found;
    best = std::move(moved);
  }
  return best;
}

}  // namespace brume
