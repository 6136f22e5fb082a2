#include "render/lighting/ordinates.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

#include "core/math/sphere_rule.h"
#include "render/lighting/environment_light.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

// So many sweeps are held at a time.
constexpr std::size_t batch = 16;

// What each node scatters towards who looks along w, channel after channel.
void scattered_along(const glm::dvec3& w, const NodeLight& incident, std::span<const double> phase,
                     std::span<float> source) {
  const ShVector<double> basis = sh_basis(static_cast<int>(phase.size()), w);
  for (std::size_t c = 0; c < incident.channels; ++c) {
    const std::span<float> target = source.subspan(c * incident.stride, incident.stride);
    std::fill(target.begin(), target.end(), 0.0f);
    for (int l = 0; l < basis.order(); ++l) {
      for (int m = -l; m <= l; ++m) {
        const std::size_t f = sh_index(l, m);
        const auto weight = static_cast<float>(phase[static_cast<std::size_t>(l)] * basis[f]);
        const float* row = incident.row(c, f).data();
        for (std::size_t i = 0; i < target.size(); ++i) target[i] += weight * row[i];
      }
    }
  }
}

// Radiance of the surfaces that hide neighbours from nodes, as the light at the nodes lights them:
// per channel and link.
std::vector<float> reflected(const GridOcclusion& surfaces, const NodeLight& incident) {
  constexpr int bands = 3;  // of the clamped cosine; the fourth has none
  assert(incident.bands >= bands);
  const ScatterTable::Bands& cosine = EnvironmentLight::cosine_factors();
  const std::size_t links = surfaces.surfels().size();
  std::vector<float> result(incident.channels * links, 0.0f);
  for (std::size_t i = 0; i < surfaces.nodes().size(); ++i) {
    const std::size_t node = surfaces.grid_nodes()[i];
    const std::size_t first = surfaces.nodes()[i].first;
    const auto count = static_cast<std::size_t>(std::popcount(surfaces.nodes()[i].blocked));
    for (std::size_t link = first; link < first + count; ++link) {
      const GridOcclusion::Surfel& surfel = surfaces.surfels()[link];
      const ShVector<float> basis = sh_basis(bands, surfel.normal);
      for (std::size_t c = 0; c < incident.channels; ++c) {
        float sum = 0.0f;
        for (int l = 0; l < bands; ++l) {
          for (std::size_t f = sh_size(l); f < sh_size(l + 1); ++f) {
            sum += cosine[static_cast<std::size_t>(l)] * basis[f] * incident.row(c, f)[node];
          }
        }
        // With one channel all surfaces are grey.
        const float reflectance = surfel.reflectance[static_cast<int>(c)];
        result[c * links + link] = reflectance * std::max(sum, 0.0f);
      }
    }
  }
  return result;
}

}  // namespace

NodeLight::NodeLight(int bands_, std::size_t channels_, std::size_t nodes)
    : bands(bands_), channels(channels_), stride(padded(nodes)) {
  values.assign(channels * functions() * stride, 0.0f);
}

std::vector<double> phase_bands(double anisotropy, int count) {
  std::vector<double> bands{1.0};
  while (bands.size() < static_cast<std::size_t>(count)) bands.push_back(bands.back() * anisotropy);
  return bands;
}

void scatter_once(const GridMedium& medium, const NodeLight& incident,
                  std::span<const double> phase, int degree, NodeLight& scattered, const Job& job) {
  assert(static_cast<int>(phase.size()) <= incident.bands);
  assert(incident.channels == scattered.channels && incident.stride == scattered.stride);
  const std::vector<SphereNode> directions = sphere_rule(degree);
  const std::size_t channels = incident.channels;
  const std::size_t stride = incident.stride;
  const std::size_t functions = scattered.functions();
  std::fill(scattered.values.begin(), scattered.values.end(), 0.0f);
  // The same for all directions if scattering is isotropic.
  std::vector<float> isotropic;
  if (phase.size() == 1) {
    isotropic.resize(channels * stride);
    scattered_along({0.0, 0.0, 1.0}, incident, phase, isotropic);
  }
  const SweepOcclusion occlusion = medium.surfaces ? medium.surfaces->sweep() : SweepOcclusion{};
  const std::vector<float> outgoing =
      medium.surfaces ? reflected(*medium.surfaces, incident) : std::vector<float>{};
  std::array<std::span<const float>, 3> outgoing_rows;
  for (std::size_t c = 0; c < channels; ++c) {
    const std::size_t links = outgoing.size() / channels;
    outgoing_rows[c] = std::span(outgoing).subspan(c * links, links);
  }
  std::vector<float> arriving(channels * batch * stride, 0.0f);
  for (std::size_t first = 0; first < directions.size(); first += batch) {
    const auto current =
        std::span(directions).subspan(first, std::min(batch, directions.size() - first));
    std::vector<float> weights;
    for (const SphereNode& node : current) {
      const ShVector<double> basis = sh_basis(scattered.bands, node.direction);
      for (const double value : basis.values()) {
        weights.push_back(static_cast<float>(value * node.weight));
      }
    }
    job.parallel_for(current.size(), [&](std::size_t k) {
      thread_local std::vector<float> memory;
      if (isotropic.empty()) {
        memory.resize(channels * stride);
        scattered_along(current[k].direction, incident, phase, memory);
      }
      const std::span<const float> all(isotropic.empty() ? memory : isotropic);
      std::array<std::span<const float>, 3> source;
      std::array<std::span<float>, 3> target;
      for (std::size_t c = 0; c < channels; ++c) {
        source[c] = all.subspan(c * stride, stride);
        target[c] = std::span(arriving).subspan((c * batch + k) * stride, stride);
      }
      sweep_emission(medium.nodes, medium.density, static_cast<float>(medium.fog),
                     std::span(source).first(channels), glm::vec3(current[k].direction), occlusion,
                     std::span(outgoing_rows).first(channels), std::span(target).first(channels));
    });
    job.parallel_for((stride + node_block - 1) / node_block, [&](std::size_t b) {
      for (std::size_t c = 0; c < channels; ++c) {
        add_weighted(
            std::span(arriving).subspan(c * batch * stride, batch * stride), weights, functions,
            stride, b * node_block, std::min((b + 1) * node_block, stride),
            std::span(scattered.values).subspan(c * functions * stride, functions * stride));
      }
    });
  }
}

}  // namespace brume
