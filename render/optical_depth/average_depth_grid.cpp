#include "render/optical_depth/average_depth_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

#include "core/transport/average_depth.h"

namespace brume {
namespace {

constexpr double max_nodes = 32'768;
constexpr double max_evaluations = 5e7;
// Evaluations of a ball that one of an ellipsoid takes, from near and from far.
constexpr double near_cost = 300.0;
constexpr double far_cost = 5.0;

// The paper's table of Tbar(u), here over s = 1 / (1 + u^2), in which Tbar / s hardly varies.
// Relative error at most 1e-4.
class UnitAverageDepth {
 public:
  UnitAverageDepth() {
    for (int i = 0; i <= intervals; ++i) {
      const double s = std::max(static_cast<double>(i) / intervals, 1e-12);
      values_[static_cast<std::size_t>(i)] =
          static_cast<float>(unit_average_depth(std::sqrt((1.0 - s) / s)) / s);
    }
  }

  float operator()(float u2) const {
    const float s = 1.0f / (1.0f + u2);
    const float coordinate = s * intervals;
    const std::size_t cell =
        std::min(static_cast<std::size_t>(coordinate), std::size_t{intervals - 1});
    const float t = coordinate - static_cast<float>(cell);
    return s * (values_[cell] + t * (values_[cell + 1] - values_[cell]));
  }

 private:
  static constexpr int intervals = 512;
  std::array<float, intervals + 1> values_;
};

// Relative to the grid's corner, where float has digits for it.
struct Term {
  glm::vec3 center;
  float a2;
  float depth;  // c / a
};

// An ellipsoid, as average_depth() has it from near. From far it is
//   m / (4 pi d^2) (1 + (4 d^T S d / d^2 - tr S) / d^2),
// of its mass m and covariance S: the mean of 1 / |d - x|^2 to the second order in x. Relative
// error at most 5e-4.
struct EllipsoidTerm {
  explicit EllipsoidTerm(const GaussianTerm<float>& near_term) : g(&near_term) {
    const glm::vec3 deviations = g->ellipsoid->stretch / (g->a * std::numbers::sqrt2_v<float>);
    half = g->ellipsoid->axes;
    for (int k = 0; k < 3; ++k) half[k] *= deviations[k];
    variance = glm::dot(deviations, deviations);
    const glm::vec3 radii = g->ellipsoid->stretch / g->a;
    mass = g->c * radii.x * radii.y * radii.z / (4.0f * std::numbers::inv_sqrtpi_v<float>);
    far2 = far_radii * far_radii / (g->a * g->a);
  }

  float operator()(const glm::vec3& p) const {
    const glm::vec3 d = p - g->b;
    const float d2 = glm::dot(d, d);
    if (d2 < far2) return average_depth(*g, p);
    const glm::vec3 along = d * half;
    return mass / d2 * (1.0f + (4.0f * glm::dot(along, along) / d2 - variance) / d2);
  }

  static constexpr float far_radii = 10.0f;

  const GaussianTerm<float>* g;
  glm::mat3 half;  // a square root of S
  float variance;  // its trace
  float mass;      // m / (4 pi)
  float far2;
};

// The nodes along each axis of a grid with that spacing.
glm::ivec3 nodes_at(const glm::dvec3& extent, double spacing) {
  return glm::ivec3(glm::ceil(glm::min(extent / spacing, max_nodes))) + 1;
}

double count(const glm::ivec3& nodes) {
  return static_cast<double>(nodes.x) * nodes.y * nodes.z;
}

// The smallest spacing of at most `max_count` nodes, at least `min_spacing`.
double spacing_for(const glm::dvec3& extent, double min_spacing, double max_count) {
  double spacing = std::max(min_spacing, 1e-4 * glm::max(extent.x, glm::max(extent.y, extent.z)));
  while (count(nodes_at(extent, spacing)) > max_count) spacing *= 1.1;
  return spacing;
}

}  // namespace

AverageDepthGrid::AverageDepthGrid(std::span<const GaussianTerm<double>> gaussians, const Box& box)
    : box_(box) {
  static const UnitAverageDepth unit_depth;
  double min_radius = std::numeric_limits<double>::infinity();
  std::vector<Term> terms;
  GaussianTerms<float> ellipsoids;
  for (const GaussianTerm<double>& g : gaussians) {
    if (!(g.c > 0.0)) continue;
    min_radius = std::min(min_radius, min_radius_of(g));
    if (g.ellipsoid) {
      Gaussian own_gaussian = gaussian_of(g);
      own_gaussian.center -= box.low;
      ellipsoids.add(own_gaussian);
      continue;
    }
    terms.push_back(
        {glm::vec3(g.b - box.low), static_cast<float>(g.a * g.a), static_cast<float>(g.c / g.a)});
  }
  const glm::dvec3 extent = box.high - box.low;
  const std::vector<EllipsoidTerm> ellipsoid_terms(ellipsoids.all().begin(),
                                                   ellipsoids.all().end());
  auto evaluations = static_cast<double>(terms.size());
  const double volume = extent.x * extent.y * extent.z;
  for (const EllipsoidTerm& term : ellipsoid_terms) {
    const double near_volume = 4.0 / 3.0 * std::numbers::pi * std::pow(term.far2, 1.5);
    evaluations += far_cost + near_cost * (near_volume < volume ? near_volume / volume : 1.0);
  }
  if (evaluations > 0.0) {
    const double max_count = std::clamp(max_evaluations / evaluations, 64.0, max_nodes);
    nodes_ = nodes_at(extent, spacing_for(extent, 0.25 * min_radius, max_count));
  }
  const glm::dvec3 cells(nodes_ - 1);
  for (int k = 0; k < 3; ++k) cells_per_unit_[k] = extent[k] > 0.0 ? cells[k] / extent[k] : 0.0;
  const glm::vec3 step(extent / glm::max(cells, 1.0));
  depths_.resize(static_cast<std::size_t>(count(nodes_)));
  tbb::parallel_for(0, nodes_.y * nodes_.z, [&](int row) {
    float* depths =
        depths_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes_.x);
    for (int x = 0; x < nodes_.x; ++x) {
      const glm::vec3 p = step * glm::vec3(x, row % nodes_.y, row / nodes_.y);
      float sum = 0.0f;
      for (const Term& term : terms) {
        const glm::vec3 q = p - term.center;
        sum += term.depth * unit_depth(term.a2 * (q.x * q.x + q.y * q.y + q.z * q.z));
      }
      for (const EllipsoidTerm& term : ellipsoid_terms) sum += term(p);
      depths[x] = sum;
    }
  });
}

float AverageDepthGrid::operator()(const glm::dvec3& p) const {
  const glm::dvec3 coordinate =
      glm::clamp((p - box_.low) * cells_per_unit_, glm::dvec3(0.0), glm::dvec3(nodes_ - 1));
  const glm::ivec3 cell = glm::min(glm::ivec3(coordinate), glm::max(nodes_ - 2, 0));
  const glm::vec3 t(coordinate - glm::dvec3(cell));
  const glm::ivec3 next = glm::min(cell + 1, nodes_ - 1);
  const auto value = [&](int x, int y, int z) {
    return depths_[(static_cast<std::size_t>(z) * static_cast<std::size_t>(nodes_.y) +
                    static_cast<std::size_t>(y)) *
                       static_cast<std::size_t>(nodes_.x) +
                   static_cast<std::size_t>(x)];
  };
  const auto row = [&](int y, int z) {
    return glm::mix(value(cell.x, y, z), value(next.x, y, z), t.x);
  };
  return glm::mix(glm::mix(row(cell.y, cell.z), row(next.y, cell.z), t.y),
                  glm::mix(row(cell.y, next.z), row(next.y, next.z), t.y), t.z);
}

}  // namespace brume
