#include "render/lighting/source_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numbers>

#include "core/math/spherical_harmonics.h"
#include "render/lighting/density_samples.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

// Extent of each Gaussian covered by the fine grid [radii]: 1% of its extinction is beyond, where
// look-ups clamp to the border.
constexpr double core_radii = 2.5;

// So many sweeps are held at a time.
constexpr std::size_t batch = 32;

// Nodes per block of a parallel sum.
constexpr std::size_t block = 1024;

struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};
  double min_radius = std::numeric_limits<double>::infinity();

  explicit Bounds(std::span<const GaussianTerm<double>> gaussians) {
    for (const GaussianTerm<double>& g : gaussians) {
      if (!(g.c > 0.0)) continue;
      low = glm::min(low, g.b - core_radii / g.a);
      high = glm::max(high, g.b + core_radii / g.a);
      min_radius = std::min(min_radius, 1.0 / g.a);
    }
  }
  [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
};

// Nodes from `low` to `high` at the smallest spacing, at least `min_spacing`, with at most
// `max_bands` nodes. The spacing is a float, to be identical wherever it is used.
SourceGrid::Level layout(const glm::dvec3& low, const glm::dvec3& high, double min_spacing,
                         int max_bands) {
  SourceGrid::Level level;
  const glm::dvec3 extent = high - low;
  double spacing = std::max(min_spacing, std::cbrt(extent.x * extent.y * extent.z / max_bands));
  for (;; spacing *= 1.02) {
    level.nodes.spacing = static_cast<float>(spacing);
    const glm::dvec3 cells = glm::ceil(extent / static_cast<double>(level.nodes.spacing));
    if ((cells.x + 1.0) * (cells.y + 1.0) * (cells.z + 1.0) > static_cast<double>(max_bands))
      continue;
    level.nodes.count = glm::max(glm::ivec3(cells) + 1, 2);
    const glm::dvec3 covered =
        glm::dvec3(level.nodes.count - 1) * static_cast<double>(level.nodes.spacing);
    level.first = 0.5 * (low + high) - 0.5 * covered;
    return level;
  }
}

// Weights of a light for each basis function of incident light (R G B) and for the clusters'
// transmittance.
void append_weights(const SourceLight& source, int bands, int clusters,
                    std::vector<float>& weights) {
  const ShVector<double> basis = sh_basis(bands, source.light.direction);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    for (int c = 0; c < 3; ++c)
      weights.push_back(static_cast<float>(basis[i] * source.light.irradiance[c]));
  }
  for (int f = 0; f < clusters; ++f) {
    weights.push_back(f == source.cluster ? static_cast<float>(source.cluster_fraction) : 0.0f);
  }
}

void fill(SourceGrid::Level& level, std::span<const GaussianTerm<double>> gaussians,
          std::span<const SourceLight> lights, const SourceGrid::Content& content, const Job& job) {
  const std::vector<float> density = density_on_grid(gaussians, level.first, level.nodes, job);
  const std::size_t nodes = level.nodes.size();
  const std::size_t stride = padded(nodes);
  const int bands = content.receivers ? grid_bands : content.bands;
  const int clusters = content.bands > 1 ? source_clusters : 0;
  const std::size_t channels = 3 * sh_size(bands) + static_cast<std::size_t>(clusters);
  std::vector<float> transmittances(std::min(batch, lights.size()) * stride, 0.0f);
  std::vector<float> sums(channels * stride, 0.0f);
  for (std::size_t first = 0; first < lights.size(); first += batch) {
    const auto batch_lights = lights.subspan(first, std::min(batch, lights.size() - first));
    std::vector<float> weights;
    for (const SourceLight& light : batch_lights) append_weights(light, bands, clusters, weights);
    job.parallel_for(batch_lights.size(), [&](std::size_t k) {
      sweep_transmittance(level.nodes, density, glm::vec3(batch_lights[k].light.direction),
                          std::span(transmittances).subspan(k * stride, nodes));
    });
    job.parallel_for((stride + block - 1) / block, [&](std::size_t b) {
      add_weighted(transmittances, weights, channels, stride, b * block,
                   std::min((b + 1) * block, stride), sums);
    });
  }
  const std::size_t functions = sh_size(content.bands);
  const std::size_t size = SourceGrid::node_size(content.bands);
  level.values.assign(size * nodes, 0.0f);
  job.parallel_for((nodes + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min((b + 1) * block, nodes); ++i) {
      for (std::size_t c = 0; c < 3 * functions; ++c) {
        level.values[size * i + 4 * (c / 3) + c % 3] = sums[c * stride + i];
      }
      for (std::size_t f = 4 * functions; f < size; ++f) {
        const std::size_t channel = 3 * sh_size(bands) + f - 4 * functions;
        level.values[size * i + f] = sums[channel * stride + i];
      }
    }
  });
  if (content.receivers) {
    level.incident =
        incident_light(level.nodes, density, sums, stride, content.receivers->optics, job);
  }
}

}  // namespace

PhaseBands::PhaseBands(double anisotropy) : count_(anisotropy == 0.0 ? 1 : max_bands) {
  double factor = 1.0;
  double lobe_scattering = std::pow(anisotropy, max_bands);
  for (double& f : factors_) {
    f = factor - lobe_scattering;
    factor *= anisotropy;
    lobe_scattering = std::copysign(lobe_scattering, factor);
  }
}

std::array<float, sh_size(PhaseBands::max_bands)> PhaseBands::at(const glm::dvec3& w) const {
  const ShVector<double> basis = sh_basis(count_, w);
  std::array<float, sh_size(max_bands)> result{};
  for (int l = 0; l < count_; ++l) {
    for (int m = -l; m <= l; ++m) {
      const std::size_t i = sh_index(l, m);
      result[i] = static_cast<float>(factors_[static_cast<std::size_t>(l)] * basis[i]);
    }
  }
  return result;
}

double PhaseBands::phase(double cosine) const {
  double sum = 0.0;
  double previous = 0.0;  // Legendre's polynomials by their recurrence
  double current = 1.0;
  for (int l = 0; l < count_; ++l) {
    sum += factors_[static_cast<std::size_t>(l)] * (2.0 * l + 1.0) * current;
    const double next = ((2.0 * l + 1.0) * cosine * current - l * previous) / (l + 1.0);
    previous = current;
    current = next;
  }
  return sum / (4.0 * std::numbers::pi);
}

SourceGrid::SourceGrid(std::span<const GaussianTerm<double>> gaussians,
                       std::span<const SourceLight> lights, const Content& content,
                       const SourceGridSize& size, const Job& job)
    : bands_(content.bands) {
  const Bounds bounds(gaussians);
  core_ = {bounds.low, bounds.high};
  if (bounds.empty()) {
    levels_.emplace_back();
  } else {
    levels_.push_back(layout(bounds.low, bounds.high, 0.12 * bounds.min_radius, size.nodes));
    if (content.has_fog || (content.receivers && !holds(content.receivers->box))) {
      const double beyond = glm::length(bounds.high - bounds.low);
      levels_.push_back(layout(bounds.low - beyond, bounds.high + beyond,
                               2.0 * static_cast<double>(levels_[0].nodes.spacing),
                               size.nodes / 2));
    }
  }
  for (Level& level : levels_) fill(level, gaussians, lights, content, job);
}

bool SourceGrid::holds(const Box& box) const {
  return glm::all(glm::lessThanEqual(core_.low, box.low)) &&
         glm::all(glm::greaterThanEqual(core_.high, box.high));
}

}  // namespace brume
