#include "render/grid/ordinates.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/gtc/quaternion.hpp>

#include "core/math/sphere_rule.h"
#include "core/scene/materials/brdf.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

// So many sweeps are held at a time.
constexpr std::size_t direction_batch = 16;

// What each node scatters towards who looks along w, channel after channel.
void scattered_along(const glm::dvec3& w, const NodeLight& incident, std::span<const double> phase,
                     std::span<const float> albedo, std::span<float> source) {
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
    for (std::size_t i = 0; i < albedo.size(); ++i) target[i] *= albedo[i];
  }
}

SweepOcclusion occlusion_of(const GridMedium& medium) {
  if (!medium.surfaces) return {};
  SweepOcclusion occlusion = medium.surfaces->sweep();
  occlusion.ends_within = medium.holds_surfaces;
  return occlusion;
}

using Channels = std::array<std::span<float>, 3>;  // rows of nodes; the rest is empty

// What a medium scatters and its surfaces send; see scatter_once(). Keeps references.
class Emission {
 public:
  Emission(const GridMedium& medium, const NodeLight& incident, std::span<const float> reflected,
           std::span<const double> phase)
      : medium_(medium), incident_(incident), phase_(phase), occlusion_(occlusion_of(medium)) {
    assert(static_cast<int>(phase.size()) <= incident.bands);
    const std::size_t links = reflected.size() / incident.channels;
    for (std::size_t c = 0; c < incident.channels; ++c) {
      sent_[c] = reflected.subspan(c * links, links);
    }
    // The same for all directions if scattering is isotropic.
    if (phase.size() > 1) return;
    isotropic_.resize(incident.channels * incident.stride);
    scattered_along({0.0, 0.0, 1.0}, incident, phase, medium.albedo, isotropic_);
  }

  // Sets the radiance that arrives at the nodes from direction w. Thread-safe.
  void sweep(const glm::dvec3& w, const Channels& arriving) const {
    thread_local std::vector<float> memory;
    const std::size_t stride = incident_.stride;
    if (isotropic_.empty()) {
      memory.resize(incident_.channels * stride);
      scattered_along(w, incident_, phase_, medium_.albedo, memory);
    }
    const std::span<const float> all(isotropic_.empty() ? memory : isotropic_);
    std::array<std::span<const float>, 3> source;
    for (std::size_t c = 0; c < incident_.channels; ++c) {
      source[c] = all.subspan(c * stride, stride);
    }
    const std::size_t channels = incident_.channels;
    sweep_emission(medium_.nodes, medium_.density, static_cast<float>(medium_.fog),
                   medium_.continues, std::span(source).first(channels), glm::vec3(w), occlusion_,
                   std::span(sent_).first(channels), std::span(arriving).first(channels));
  }

 private:
  const GridMedium& medium_;
  const NodeLight& incident_;
  std::span<const double> phase_;
  SweepOcclusion occlusion_;
  std::array<std::span<const float>, 3> sent_;
  std::vector<float> isotropic_;
};

// Adds what arrives at the nodes from direction w of the radiance `border` at the grid's border.
void add_inflow(const GridMedium& medium, const glm::dvec3& w, std::span<float> border,
                std::span<float> arriving) {
  // The sweep is of a fraction.
  const float max = *std::ranges::max_element(border);
  if (!(max > 0.0f)) return;
  for (float& value : border) value = std::max(value / max, 0.0f);
  thread_local std::vector<float> transmitted;
  transmitted.resize(medium.nodes.size());
  sweep_transmittance(medium.nodes, medium.density, glm::vec3(w), occlusion_of(medium), border,
                      transmitted);
  for (std::size_t i = 0; i < transmitted.size(); ++i) arriving[i] += max * transmitted[i];
}

// A quadrature rule, in fog alone turned so that no direction lies along the floors and walls of
// most scenes, which parallel the axes: light along a black floor is neither that from above nor
// that from below, and a fifth of the weights was on it. Among Gaussians that gains nothing: the
// tunnel was 7% too dark instead of 5%.
std::vector<SphereNode> ordinates(int degree, const GridMedium& medium) {
  std::vector<SphereNode> directions = sphere_rule(degree);
  if (!medium.surfaces || !medium.is_fog_alone) return directions;
  const glm::dquat turn = glm::normalize(glm::dquat(0.77, 0.22, -0.32, 0.51));
  for (SphereNode& node : directions) node.direction = turn * node.direction;
  return directions;
}

// Sets `light` to what arrives at its nodes from these directions, given for each by
// sweep(w, arriving).
template <class DirectionSweep>
void integrate(std::span<const SphereNode> directions, NodeLight& light, const Job& job,
               DirectionSweep sweep) {
  const std::size_t channels = light.channels;
  const std::size_t stride = light.stride;
  const std::size_t functions = light.functions();
  std::fill(light.values.begin(), light.values.end(), 0.0f);
  std::vector<float> arriving(channels * direction_batch * stride, 0.0f);
  for (std::size_t first = 0; first < directions.size(); first += direction_batch) {
    const auto current =
        directions.subspan(first, std::min(direction_batch, directions.size() - first));
    std::vector<float> weights;
    for (const SphereNode& node : current) {
      const ShVector<double> basis = sh_basis(light.bands, node.direction);
      for (const double value : basis.values()) {
        weights.push_back(static_cast<float>(value * node.weight));
      }
    }
    job.parallel_for(current.size(), [&](std::size_t k) {
      Channels target;
      for (std::size_t c = 0; c < channels; ++c) {
        target[c] = std::span(arriving).subspan((c * direction_batch + k) * stride, stride);
      }
      sweep(current[k].direction, target);
    });
    job.parallel_for((stride + node_block - 1) / node_block, [&](std::size_t b) {
      for (std::size_t c = 0; c < channels; ++c) {
        add_weighted(
            std::span(arriving).subspan(c * direction_batch * stride, direction_batch * stride),
            weights, functions, stride, b * node_block, std::min((b + 1) * node_block, stride),
            std::span(light.values).subspan(c * functions * stride, functions * stride));
      }
    });
  }
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

double forward_lobe(double anisotropy, int count) {
  constexpr double nearer_bands = 0.15;
  return std::pow(std::max(anisotropy, 0.0), count - nearer_bands);
}

std::vector<float> reflected_light(const GridOcclusion& surfaces, const NodeLight& incident) {
  constexpr int bands = 3;  // of the clamped cosine; the fourth has none
  assert(incident.bands >= bands);
  const ZonalSh<float>& cosine = clamped_cosine_factors();
  const std::size_t links = surfaces.surfels().size();
  std::vector<float> result(incident.channels * links, 0.0f);
  for (std::size_t i = 0; i < surfaces.nodes().size(); ++i) {
    const std::size_t node = surfaces.grid_nodes()[i];
    std::size_t link = surfaces.nodes()[i].first;
    for (const GridOcclusion::Surfel& surfel : surfaces.surfels_of(i)) {
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
      ++link;
    }
  }
  return result;
}

void scatter_once(const GridMedium& medium, const NodeLight& incident,
                  std::span<const float> reflected, std::span<const double> phase, int degree,
                  NodeLight& scattered, const Job& job) {
  assert(incident.channels == scattered.channels && incident.stride == scattered.stride);
  const Emission emission(medium, incident, reflected, phase);
  integrate(ordinates(degree, medium), scattered, job,
            [&](const glm::dvec3& w, const Channels& arriving) { emission.sweep(w, arriving); });
}

NodeLight scatter_into(const GridMedium& medium, std::span<const OuterLevel> outer,
                       std::span<const double> phase, int degree, const Job& job) {
  std::vector<Emission> emissions;
  for (const OuterLevel& level : outer) {
    emissions.emplace_back(level.medium, level.incident, level.reflected, phase);
  }
  const NodeLight& nearest = outer.front().incident;
  NodeLight result(nearest.bands, nearest.channels, medium.nodes.size());
  integrate(
      ordinates(degree, medium), result, job, [&](const glm::dvec3& w, const Channels& arriving) {
        std::array<std::vector<float>, 3> inflow;  // at the border; of the outermost level none
        for (std::size_t k = outer.size(); k-- > 0;) {
          const OuterLevel& level = outer[k];
          std::array<std::vector<float>, 3> around;
          Channels rows;
          for (std::size_t c = 0; c < nearest.channels; ++c) {
            around[c].resize(level.incident.stride);
            rows[c] = around[c];
          }
          emissions[k].sweep(w, rows);
          const std::size_t nodes = k > 0 ? outer[k - 1].medium.nodes.size() : medium.nodes.size();
          for (std::size_t c = 0; c < nearest.channels; ++c) {
            if (!inflow[c].empty()) add_inflow(level.medium, w, inflow[c], around[c]);
            inflow[c].assign(nodes, 0.0f);
            level.finer.apply_to_border(around[c], inflow[c]);
          }
        }
        for (std::size_t c = 0; c < nearest.channels; ++c) {
          std::ranges::fill(arriving[c], 0.0f);
          add_inflow(medium, w, inflow[c], arriving[c]);
        }
      });
  return result;
}

}  // namespace brume
