#include "core/transport/medium_summary.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/math/max_component.h"
#include "core/medium/gaussian_term.h"
#include "core/transport/optical_depth.h"

namespace brume {
namespace {

// The limit of the whole search, in evaluations of one Gaussian at a point or along a line: some
// seven seconds of one thread, however many Gaussians there are.
constexpr std::size_t max_evaluations = 200'000'000;

// Number of sums over all Gaussians per part of the search: first all `directions` through each of
// `centers`, then `steps` from each of the `starts` best lines. The two share the budget.
struct SearchSize {
  std::size_t centers;
  std::size_t directions;
  std::size_t starts;
  std::size_t steps;
};

SearchSize search_size(std::size_t gaussians) {
  const std::size_t half = max_evaluations / gaussians / 2;
  SearchSize size{};
  // A center also costs a density evaluation.
  size.centers =
      std::clamp<std::size_t>(half / (64 + 1), 1, std::min<std::size_t>(gaussians, 1024));
  size.directions = std::clamp<std::size_t>(half / size.centers, 2, 64 + 1) - 1;
  const std::size_t lines = size.centers * size.directions;
  size.starts = std::clamp<std::size_t>(half / 300, 1, std::min<std::size_t>(lines, 24));
  size.steps = std::min<std::size_t>(half / size.starts, 300);
  return size;
}

// Points of a Fibonacci lattice on the half sphere z > 0; a line has no orientation.
glm::dvec3 direction(std::size_t index, std::size_t count) {
  const double z = (static_cast<double>(index) + 0.5) / static_cast<double>(count);
  const double angle = static_cast<double>(index) * std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

struct Line {
  glm::dvec3 point{0.0};
  glm::dvec3 direction{0.0, 0.0, 1.0};  // unit
  double depth = 0.0;
};

// Along the whole line: sum of sqrt(pi) radius density exp(-h^2 / radius^2).
double optical_depth_of_line(const GaussianTerms<double>& terms, const glm::dvec3& point,
                             const glm::dvec3& w) {
  double sum = 0.0;
  for (const GaussianTerm<double>& term : terms.all()) {
    const LineProfile<double> line = line_profile(term, point, w);
    sum += std::sqrt(std::numbers::pi) * term.c / line.a * std::exp(-line.e);
  }
  return sum;
}

// Moves a line sideways (in units of `size`) and turns it as long as it gets deeper, by ever
// smaller steps, of which it tries `max_steps` at most.
Line deepest_nearby(const GaussianTerms<double>& terms, Line line, double size,
                    std::size_t max_steps) {
  constexpr std::size_t moves = 8;  // tried in each round
  double step = 0.25;
  for (std::size_t tried = 0; tried + moves <= max_steps && step > 1e-3; tried += moves) {
    const glm::dvec3& w = line.direction;
    const glm::dvec3 u = glm::normalize(
        glm::cross(w, std::abs(w.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(w, u);
    Line best = line;
    for (const glm::dvec3& d : {u, -u, v, -v}) {
      for (const Line& next : {Line{line.point + step * size * d, w},
                               Line{line.point, glm::normalize(w + 0.3 * step * d)}}) {
        const double depth = optical_depth_of_line(terms, next.point, next.direction);
        if (depth > best.depth) best = {next.point, next.direction, depth};
      }
    }
    if (best.depth > line.depth) {
      line = best;
    } else {
      step *= 0.5;
    }
  }
  return line;
}

double density_at(const GaussianTerms<double>& terms, double b0, const glm::dvec3& point) {
  double sum = b0;
  for (const GaussianTerm<double>& term : terms.all()) {
    const glm::dvec3 offset = term.scaled(point);
    sum += term.c * std::exp(-glm::dot(offset, offset));
  }
  return sum;
}

template <typename Function>
double max_of(std::size_t count, Function&& function) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, count), 0.0,
      [&](const tbb::blocked_range<std::size_t>& range, double max_value) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          max_value = std::max(max_value, function(i));
        }
        return max_value;
      },
      [](double a, double b) { return std::max(a, b); });
}

// Indices of the Gaussians of largest optical depth.
std::vector<std::size_t> thickest(const Medium& medium, std::size_t count) {
  std::vector<std::size_t> order(medium.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  count = std::min(count, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      const double depth_a = medium.radii()[a] * medium.densities()[a];
                      const double depth_b = medium.radii()[b] * medium.densities()[b];
                      return depth_a != depth_b ? depth_a > depth_b : a < b;
                    });
  order.resize(count);
  return order;
}

}  // namespace

MediumSummary summarize(const Medium& medium) {
  MediumSummary summary;
  summary.peak_density = medium.homogeneous_density();
  const std::size_t size = medium.size();
  if (size == 0) return summary;

  summary.min_center = summary.max_center = medium.centers()[0];
  summary.min_radius = summary.max_radius = medium.radii()[0];
  summary.min_extent = summary.max_extent = medium.centers()[0];
  for (std::size_t i = 0; i < size; ++i) {
    const glm::dvec3& center = medium.centers()[i];
    const double radius = medium.radii()[i];
    const GaussianShape shape = medium.shape(i);
    glm::dvec3 reach(radius);
    if (shape != GaussianShape()) reach *= Ellipsoid<double>(shape).reach();
    summary.min_center = glm::min(summary.min_center, center);
    summary.max_center = glm::max(summary.max_center, center);
    summary.min_extent = glm::min(summary.min_extent, center - 2.0 * reach);
    summary.max_extent = glm::max(summary.max_extent, center + 2.0 * reach);
    summary.min_radius = std::min(summary.min_radius, radius * min_component(shape.stretch));
    summary.max_radius = std::max(summary.max_radius, radius);
  }

  const GaussianTerms<double> terms(medium);
  const SearchSize search = search_size(size);
  const std::vector<std::size_t> centers = thickest(medium, search.centers);
  summary.peak_density = std::max(summary.peak_density, max_of(centers.size(), [&](auto i) {
                                    return density_at(terms, medium.homogeneous_density(),
                                                      medium.centers()[centers[i]]);
                                  }));

  std::vector<Line> lines(search.centers * search.directions);
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
    lines[i] = {medium.centers()[centers[i / search.directions]],
                direction(i % search.directions, search.directions)};
    lines[i].depth = optical_depth_of_line(terms, lines[i].point, lines[i].direction);
  });
  std::partial_sort(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(search.starts),
                    lines.end(), [](const Line& a, const Line& b) { return a.depth > b.depth; });
  summary.max_optical_depth = max_of(search.starts, [&](std::size_t i) {
    return deepest_nearby(terms, lines[i], summary.max_radius, search.steps).depth;
  });
  return summary;
}

}  // namespace brume
