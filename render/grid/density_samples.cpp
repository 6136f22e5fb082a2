#include "render/grid/density_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace brume {
namespace {

// Gaussians are followed to this many radii, where they are down to 1e-4.
constexpr double followed = 3.0;

// A Gaussian along one axis of the grid: exp(-u^2) at the nodes in its range, by a recurrence of
// two multiplications, since u grows evenly.
struct Profile {
  int begin = 0;
  std::vector<float> values;

  void assign(double center, double radius, double spacing, int count) {
    begin = std::max(0, static_cast<int>(std::ceil((center - followed * radius) / spacing)));
    const int end =
        std::min(count, static_cast<int>(std::floor((center + followed * radius) / spacing)) + 1);
    const double first = (begin * spacing - center) / radius;
    const double step = spacing / radius;
    double value = std::exp(-first * first);
    double ratio = std::exp(-(2.0 * first + step) * step);
    const double change = std::exp(-2.0 * step * step);
    values.clear();
    for (int i = begin; i < end; ++i) {
      values.push_back(static_cast<float>(value));
      value *= ratio;
      ratio *= change;
    }
  }
};

// An ellipsoid, each of its radii at least the spacing, by the same recurrence along each row.
void add_ellipsoid(const GaussianTerm<double>& g, const glm::dvec3& first, const GridNodes& nodes,
                   std::vector<float>& density) {
  const double spacing = static_cast<double>(nodes.spacing);
  const glm::dvec3 own = g.ellipsoid->stretch / g.a;
  const glm::dvec3 radii = glm::max(own, spacing);
  const glm::dvec3 shares = own / radii;
  const double peak = g.c * shares.x * shares.y * shares.z;
  const glm::dmat3& axes = g.ellipsoid->axes;
  // Minus the exponent is q . form q.
  glm::dmat3 form(0.0);
  glm::dvec3 reach(0.0);
  for (int k = 0; k < 3; ++k) {
    form += glm::outerProduct(axes[k], axes[k]) / (radii[k] * radii[k]);
    reach += glm::dvec3(radii[k] * radii[k]) * axes[k] * axes[k];
  }
  reach = followed * glm::sqrt(reach);
  const glm::dvec3 center = g.b - first;
  const glm::dvec3 low = glm::max(glm::ceil((center - reach) / spacing), glm::dvec3(0.0));
  const glm::dvec3 high =
      glm::min(glm::floor((center + reach) / spacing), glm::dvec3(nodes.count - 1));
  if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z)) return;
  const glm::ivec3 begin(low);
  const glm::ivec3 last(high);
  // exp(-xx (x - middle)^2 - rest) along a row.
  const double xx = form[0][0];
  const double change = std::exp(-2.0 * xx * spacing * spacing);
  for (int z = begin.z; z <= last.z; ++z) {
    for (int y = begin.y; y <= last.y; ++y) {
      const glm::dvec3 q =
          glm::dvec3(0.0, y * spacing, z * spacing) - glm::dvec3(0.0, center.y, center.z);
      const double middle = -(form[1][0] * q.y + form[2][0] * q.z) / xx;
      const double rest = glm::dot(q, form * q) - xx * middle * middle;
      const double left = followed * followed - rest;
      if (!(left > 0.0)) continue;
      const double half = std::sqrt(left / xx);
      const double at = center.x + middle;
      const int x0 = std::max(begin.x, static_cast<int>(std::ceil((at - half) / spacing)));
      const int x1 = std::min(last.x, static_cast<int>(std::floor((at + half) / spacing)));
      if (x0 > x1) continue;
      const double offset = x0 * spacing - at;
      double value = peak * std::exp(-(xx * offset * offset + rest));
      double ratio = std::exp(-xx * (2.0 * offset + spacing) * spacing);
      float* target =
          density.data() + (static_cast<std::size_t>(z) * static_cast<std::size_t>(nodes.count.y) +
                            static_cast<std::size_t>(y)) *
                               static_cast<std::size_t>(nodes.count.x);
      for (int x = x0; x <= x1; ++x) {
        target[x] += static_cast<float>(value);
        value *= ratio;
        ratio *= change;
      }
    }
  }
}

// Adds what some Gaussians are at the nodes.
void add_density(std::span<const GaussianTerm<double>> gaussians, const glm::dvec3& first,
                 const GridNodes& nodes, std::vector<float>& density) {
  const double spacing = static_cast<double>(nodes.spacing);
  const auto width = static_cast<std::size_t>(nodes.count.x);
  const auto height = static_cast<std::size_t>(nodes.count.y);
  Profile x, y, z;
  for (const GaussianTerm<double>& g : gaussians) {
    if (g.ellipsoid) {
      add_ellipsoid(g, first, nodes, density);
      continue;
    }
    const double radius = std::max(1.0 / g.a, spacing);
    const double widened = 1.0 / (g.a * radius);
    const auto peak = static_cast<float>(g.c * widened * widened * widened);
    const glm::dvec3 center = g.b - first;
    x.assign(center.x, radius, spacing, nodes.count.x);
    y.assign(center.y, radius, spacing, nodes.count.y);
    z.assign(center.z, radius, spacing, nodes.count.z);
    for (std::size_t k = 0; k < z.values.size(); ++k) {
      for (std::size_t j = 0; j < y.values.size(); ++j) {
        const float scale = peak * z.values[k] * y.values[j];
        const std::size_t row = (static_cast<std::size_t>(z.begin) + k) * height +
                                static_cast<std::size_t>(y.begin) + j;
        float* target = density.data() + row * width + static_cast<std::size_t>(x.begin);
        for (std::size_t i = 0; i < x.values.size(); ++i) target[i] += scale * x.values[i];
      }
    }
  }
}

}  // namespace

std::vector<float> density_on_grid(std::span<const GaussianTerm<double>> gaussians,
                                   const glm::dvec3& first, const GridNodes& nodes,
                                   const Job& job) {
  // Parts whose sums are added in their order: the same whatever the threads.
  constexpr std::size_t max_parts = 16;
  constexpr std::size_t least = 64;  // Gaussians of a part
  const std::size_t count = std::clamp<std::size_t>(gaussians.size() / least, 1, max_parts);
  std::vector<std::vector<float>> parts(count);
  job.parallel_for(count, [&](std::size_t part) {
    const std::size_t begin = part * gaussians.size() / count;
    const std::size_t end = (part + 1) * gaussians.size() / count;
    parts[part].assign(nodes.size(), 0.0f);
    add_density(gaussians.subspan(begin, end - begin), first, nodes, parts[part]);
  });
  std::vector<float> density(nodes.size(), 0.0f);
  for (const std::vector<float>& part : parts) {
    for (std::size_t i = 0; i < part.size(); ++i) density[i] += part[i];
  }
  return density;
}

}  // namespace brume
