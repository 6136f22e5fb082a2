#include "render/lighting/density_samples.h"

#include <algorithm>
#include <cmath>

namespace brume {
namespace {

// Gaussians are followed to this many radii, where they are down to 1e-4.
constexpr double followed = 3.0;

// A Gaussian along one axis of the grid: exp(-a^2 x^2) at the nodes in its range.
struct Profile {
  int begin = 0;
  std::vector<float> values;

  void assign(double center, double radius, double spacing, int count) {
    begin = std::max(0, static_cast<int>(std::ceil((center - followed * radius) / spacing)));
    const int end =
        std::min(count, static_cast<int>(std::floor((center + followed * radius) / spacing)) + 1);
    values.clear();
    for (int i = begin; i < end; ++i) {
      const double u = (i * spacing - center) / radius;
      values.push_back(static_cast<float>(std::exp(-u * u)));
    }
  }
  [[nodiscard]] int end() const { return begin + static_cast<int>(values.size()); }
};

}  // namespace

std::vector<float> density_on_grid(std::span<const GaussianTerm<double>> gaussians,
                                   const glm::dvec3& first, const GridNodes& nodes,
                                   const Job& job) {
  const double spacing = static_cast<double>(nodes.spacing);
  std::vector<float> density(nodes.size(), 0.0f);
  const auto width = static_cast<std::size_t>(nodes.count.x);
  const auto slab = width * static_cast<std::size_t>(nodes.count.y);
  job.parallel_for(static_cast<std::size_t>(nodes.count.z), [&](std::size_t z) {
    Profile x;
    Profile y;
    for (const GaussianTerm<double>& g : gaussians) {
      const double radius = std::max(1.0 / g.a, spacing);
      const glm::dvec3 center = g.b - first;
      const double u = (static_cast<double>(z) * spacing - center.z) / radius;
      if (std::abs(u) > followed) continue;
      const double widened = 1.0 / (g.a * radius);
      const double peak = g.c * widened * widened * widened * std::exp(-u * u);
      x.assign(center.x, radius, spacing, nodes.count.x);
      y.assign(center.y, radius, spacing, nodes.count.y);
      for (int row = y.begin; row < y.end(); ++row) {
        const float scale =
            static_cast<float>(peak) * y.values[static_cast<std::size_t>(row - y.begin)];
        float* target = density.data() + z * slab + static_cast<std::size_t>(row) * width +
                        static_cast<std::size_t>(x.begin);
        for (std::size_t i = 0; i < x.values.size(); ++i) target[i] += scale * x.values[i];
      }
    }
  });
  return density;
}

}  // namespace brume
