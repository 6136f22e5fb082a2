#include "render/lighting/incident_grid.h"

#include <algorithm>
#include <cmath>

#include "core/math/sphere_rule.h"

namespace brume {
namespace {

constexpr auto functions = sh_size(grid_bands);

// Directions that scattered light comes from: a rule that is exact for the square of four bands,
// and one more for what lies beyond them.
constexpr int degree = 9;

// So many sweeps are held at a time.
constexpr std::size_t batch = 10;

// Nodes per block of a parallel sum.
constexpr std::size_t block = 1024;

using Rows = std::array<std::span<const float>, 3>;  // R G B

// Rows of what each node scatters from light that comes from all sides towards who looks along w.
class Source {
 public:
  Source(std::span<const float> unscattered, std::size_t stride, double anisotropy)
      : unscattered_(unscattered), stride_(stride), anisotropy_(anisotropy) {}

  [[nodiscard]] Rows seen_along(const glm::dvec3& w, std::vector<float>& memory) const {
    memory.assign(3 * stride_, 0.0f);
    const ShVector<double> basis = sh_basis(anisotropy_ == 0.0 ? 1 : grid_bands, w);
    double factor = 1.0;
    for (int l = 0; l < basis.order(); ++l, factor *= anisotropy_) {
      for (int m = -l; m <= l; ++m) {
        const std::size_t f = sh_index(l, m);
        const auto weight = static_cast<float>(factor * basis[f]);
        const float* input = unscattered_.data() + 3 * f * stride_;
        for (std::size_t i = 0; i < memory.size(); ++i) memory[i] += weight * input[i];
      }
    }
    const std::span<const float> all(memory);
    return {all.first(stride_), all.subspan(stride_, stride_), all.last(stride_)};
  }

 private:
  std::span<const float> unscattered_;
  std::size_t stride_;
  double anisotropy_;
};

// The coefficients of what the Gaussians scatter to each node: for each of R G B a row of `stride`
// elements for each coefficient.
std::vector<float> scattered_light(const GridNodes& nodes, std::span<const float> density,
                                   const Source& source, std::size_t stride, double fog,
                                   const Job& job) {
  const std::vector<SphereNode> directions = sphere_rule(degree);
  std::vector<float> sums(3 * functions * stride, 0.0f);
  std::vector<float> emitted(3 * batch * stride, 0.0f);
  for (std::size_t first = 0; first < directions.size(); first += batch) {
    const auto now =
        std::span(directions).subspan(first, std::min(batch, directions.size() - first));
    const auto row = [&](std::size_t c, std::size_t k) {
      return std::span(emitted).subspan((c * batch + k) * stride, stride);
    };
    std::vector<float> weights;
    for (const SphereNode& node : now) {
      const ShVector<double> basis = sh_basis(grid_bands, node.direction);
      for (std::size_t f = 0; f < functions; ++f) {
        weights.push_back(static_cast<float>(basis[f] * node.weight));
      }
    }
    job.parallel_for(now.size(), [&](std::size_t k) {
      thread_local std::vector<float> memory;
      const glm::dvec3& w = now[k].direction;
      sweep_emission(nodes, density, static_cast<float>(fog), source.seen_along(w, memory),
                     glm::vec3(w), {row(0, k), row(1, k), row(2, k)});
    });
    job.parallel_for((stride + block - 1) / block, [&](std::size_t b) {
      for (std::size_t c = 0; c < 3; ++c) {
        add_weighted(std::span(emitted).subspan(c * batch * stride, batch * stride), weights,
                     functions, stride, b * block, std::min((b + 1) * block, stride),
                     std::span(sums).subspan(c * functions * stride, functions * stride));
      }
    });
  }
  return sums;
}

}  // namespace

std::vector<float> incident_light(const GridNodes& nodes, std::span<const float> density,
                                  std::span<const float> unscattered, std::size_t stride,
                                  const IncidentOptics& optics, const Job& job) {
  const std::vector<float> scattered =
      scattered_light(nodes, density, Source(unscattered, stride, optics.anisotropy), stride,
                      optics.fog_density, job);
  const auto scale = static_cast<float>(optics.scattered);
  std::vector<float> values(4 * functions * nodes.size(), 0.0f);
  job.parallel_for((nodes.size() + block - 1) / block, [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * block, nodes.size());
    for (int l = 0; l < grid_bands; ++l) {
      const auto transmittance =
          static_cast<float>(optics.through_fog[static_cast<std::size_t>(l)]);
      for (int m = -l; m <= l; ++m) {
        const std::size_t f = sh_index(l, m);
        for (std::size_t c = 0; c < 3; ++c) {
          const float* input = unscattered.data() + (3 * f + c) * stride;
          const float* outgoing = scattered.data() + (c * functions + f) * stride;
          for (std::size_t i = b * block; i < end; ++i) {
            values[4 * (functions * i + f) + c] = transmittance * input[i] + scale * outgoing[i];
          }
        }
      }
    }
  });
  return values;
}

}  // namespace brume
