#include "render/grid/ordinates.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>
#include <optional>

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
  return medium.surfaces ? medium.surfaces->sweep() : SweepOcclusion();
}

// Calls exchange(node, its next along an axis) for all neighbours of a grid that see each other.
template <class Exchange>
void each_open_pair(const GridMedium& medium, Exchange exchange) {
  const GridNodes& nodes = medium.nodes;
  const std::span<const std::uint32_t> hidden =
      medium.surfaces ? medium.surfaces->hidden() : std::span<const std::uint32_t>();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const glm::ivec3 place = node_coordinates(nodes, i);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 step(0);
      step[axis] = 1;
      if (place[axis] + 1 >= nodes.count[axis]) continue;
      if (!hidden.empty() && (hidden[i] >> neighbour_index(step.x, step.y, step.z) & 1u) != 0) {
        continue;
      }
      exchange(i, node_index(nodes, place + step));
    }
  }
}

// Sweeps take the source as linear between the slabs of nodes that light passes through, as if each
// node's were spread along its way: light diffuses too fast, by a twelfth of the squared way
// between slabs, in units of mean free paths. This takes as much from its neighbours in advance, on
// average over directions; what all nodes send stays. Nothing changes where nodes are mean free
// paths apart: the iteration would end no more. The phase function has `bands`; others stay.
NodeLight sharpened(const GridMedium& medium, const NodeLight& incident, int bands,
                    const Job& job) {
  // The mean of that squared way over all directions is 1.516 squared spacings; a third of it is
  // along each axis.
  constexpr float exchanged = 1.516f / 36.0f;
  constexpr float no_more = 1.5f;  // optical depth between nodes; it fades from 0.5 on
  NodeLight result = incident;
  const std::size_t functions = sh_size(bands);
  job.parallel_for(incident.channels * functions, [&](std::size_t k) {
    const std::span<const float> light = incident.row(k / functions, k % functions);
    const std::span<float> sharp = result.row(k / functions, k % functions);
    each_open_pair(medium, [&](std::size_t i, std::size_t j) {
      const float first = medium.density[i];
      const float second = medium.density[j];
      if (!(first > 0.0f && second > 0.0f)) return;
      const float depth = 0.5f * medium.nodes.spacing * (first + second);
      const float share = exchanged * std::clamp(no_more - depth, 0.0f, 1.0f);
      const float flow = share * std::min(first, second) * (light[i] - light[j]);
      sharp[i] += flow / first;
      sharp[j] -= flow / second;
    });
  });
  return result;
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
    isotropic_.resize(incident_.channels * incident_.stride);
    scattered_along({0.0, 0.0, 1.0}, incident_, phase, medium.albedo, isotropic_);
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

// The light that endless fog sends back to the nodes of a grid's border, where it diffuses.
class LightFromBeyond {
 public:
  LightFromBeyond(const GridMedium& medium, const NodeLight& incident)
      : medium_(medium), incident_(incident) {
    for (std::size_t i = 0; i < medium.nodes.size(); ++i) {
      const glm::ivec3 place = node_coordinates(medium.nodes, i);
      if (glm::any(glm::equal(place, glm::ivec3(0))) ||
          glm::any(glm::equal(place, medium.nodes.count - 1))) {
        border_.push_back({i, static_cast<double>(medium.nodes.spacing) * glm::dvec3(place) -
                                  medium.beyond->lights});
      }
    }
  }

  // Adds what arrives from direction w. Thread-safe.
  void add(const glm::dvec3& w, const Channels& arriving) const {
    thread_local std::vector<float> shares;
    shares.clear();
    for (const BorderNode& node : border_) shares.push_back(share_from(w, node.from_lights));
    thread_local std::vector<float> inflow;
    for (std::size_t c = 0; c < incident_.channels; ++c) {
      const std::span<const float> mean = incident_.row(c, 0);
      inflow.assign(medium_.nodes.size(), 0.0f);
      for (std::size_t k = 0; k < border_.size(); ++k) {
        inflow[border_[k].node] =
            shares[k] * mean[border_[k].node] / std::sqrt(4.0f * std::numbers::pi_v<float>);
      }
      add_inflow(medium_, w, inflow, arriving[c]);
    }
  }

 private:
  struct BorderNode {
    std::size_t node;
    glm::dvec3 from_lights;  // [u]
  };

  // The radiance from direction w relative to the mean of all directions: what scattering, as if it
  // were isotropic, adds along the way. Gauss-Laguerre quadrature; the first order of diffusion is
  // not enough: 9 mean free paths from a light it would be 10% of the light there.
  [[nodiscard]] float share_from(const glm::dvec3& w, const glm::dvec3& q) const {
    struct Point {
      double depth, weight;
    };
    constexpr std::array<Point, 3> rule{{{0.4157745567834791, 0.7110930099291730},
                                         {2.294280360279042, 0.2785177335692409},
                                         {6.289945082937479, 0.01038925650158613}}};
    constexpr double most = 2.0;  // past the lights' middle, which no one light need be at
    const EndlessFog& fog = *medium_.beyond;
    const double r = glm::length(q);
    double sum = 0.0;
    for (const Point& point : rule) {
      const double distance = glm::length(q + point.depth / fog.transport_extinction * w);
      const double fluence =
          distance > 0.0 ? std::exp(fog.decay * (r - distance)) * r / distance : most;
      sum += point.weight * std::min(fluence, most);
    }
    return static_cast<float>(fog.albedo * sum);
  }

  const GridMedium& medium_;
  const NodeLight& incident_;
  std::vector<BorderNode> border_;
};

// A quadrature rule, among surfaces turned so that no direction lies along the floors and walls of
// most scenes, which parallel the axes: light along a floor is neither that from above nor that
// from below, and a fifth of the weights was on it. A cloud over a light floor was 7% too dark.
std::vector<SphereNode> ordinates(int degree, const GridMedium& medium) {
  std::vector<SphereNode> directions = sphere_rule(degree);
  if (!medium.surfaces) return directions;
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

EndlessFog::EndlessFog(double density, double scattering_albedo, double anisotropy,
                       const glm::dvec3& middle_of_lights)
    : transport_extinction(density * (1.0 - scattering_albedo * anisotropy)),
      decay(std::sqrt(3.0 * (1.0 - scattering_albedo) * density * transport_extinction)),
      albedo(scattering_albedo * (1.0 - anisotropy) / (1.0 - scattering_albedo * anisotropy)),
      lights(middle_of_lights) {}

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
  std::optional<NodeLight> sharp;
  if (medium.is_fog_alone || medium.beyond) {
    sharp = sharpened(medium, incident, static_cast<int>(phase.size()), job);
  }
  const Emission emission(medium, sharp ? *sharp : incident, reflected, phase);
  std::optional<LightFromBeyond> from_beyond;
  if (medium.beyond) from_beyond.emplace(medium, incident);
  integrate(ordinates(degree, medium), scattered, job,
            [&](const glm::dvec3& w, const Channels& arriving) {
              emission.sweep(w, arriving);
              if (from_beyond) from_beyond->add(w, arriving);
            });
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
            level.inflow->apply(around[c], inflow[c]);
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
