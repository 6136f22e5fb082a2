#include "render/scattering/source_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "core/math/special_functions.h"
#include "core/math/spherical_harmonics.h"
#include "render/grid/density_samples.h"
#include "render/scattering/grid_layout.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

// So many sweeps are held at a time.
constexpr std::size_t sweep_batch = 32;

// Weights of the transmittance towards each light: of the coefficients of its light, channel after
// channel, and of the clusters.
struct LightWeights {
  std::vector<float> light, clusters;

  LightWeights(std::span<const SourceLight> lights, int bands, int cluster_count) {
    for (const SourceLight& source : lights) {
      const ShVector<double> basis = sh_basis(bands, source.light.direction);
      for (int c = 0; c < 3; ++c) {
        for (const double value : basis.values()) {
          light.push_back(static_cast<float>(value * source.light.irradiance[c]));
        }
      }
      for (int f = 0; f < cluster_count; ++f) {
        clusters.push_back(f == source.cluster ? static_cast<float>(source.cluster_fraction)
                                               : 0.0f);
      }
    }
  }
};

// Light transmitted to the nodes of a level; what surfaces then reflect of it, see
// reflected_light(); and the clusters' mean transmittances as rows.
struct Transmitted {
  NodeLight light;
  std::vector<float> reflected;
  std::vector<float> clusters;
};

// Adds to `reflected` what surfaces reflect of one light. Not from the bands of its light: three of
// them light surfaces that the light only grazes.
void add_reflected(const GridOcclusion& surfaces, const DistantLight& light,
                   std::span<const float> transmittances, std::span<float> reflected) {
  const std::size_t links = surfaces.surfels().size();
  const glm::vec3 w(light.direction);
  const glm::vec3 radiance(light.irradiance * std::numbers::inv_pi);
  for (std::size_t i = 0; i < surfaces.nodes().size(); ++i) {
    const float passes = transmittances[surfaces.grid_nodes()[i]];
    std::size_t link = surfaces.nodes()[i].first;
    for (const GridOcclusion::Surfel& surfel : surfaces.surfels_of(i)) {
      const float cosine = glm::dot(surfel.normal, w);
      for (std::size_t c = 0; cosine > 0.0f && c < 3; ++c) {
        const int k = static_cast<int>(c);
        reflected[c * links + link] += cosine * passes * surfel.reflectance[k] * radiance[k];
      }
      ++link;
    }
  }
}

glm::dvec3 node_position(const SourceGrid::Level& level, std::size_t node) {
  const double spacing = static_cast<double>(level.nodes.spacing);
  return level.first + spacing * glm::dvec3(node_coordinates(level.nodes, node));
}

glm::dvec3 last_position(const SourceGrid::Level& level) {
  return node_position(level, level.nodes.size() - 1);
}

// The occlusion that light from direction w meets.
SweepOcclusion occlusion_of(const SourceGrid::Level& level, const LevelOcclusion* surfaces,
                            const glm::dvec3& w) {
  if (!level.surfaces) return {};
  SweepOcclusion occlusion = level.surfaces->sweep();
  occlusion.is_lit = [&level, surfaces, w](std::size_t node) {
    return !surfaces->hide(node_position(level, node), w);
  };
  return occlusion;
}

// Share of a cell around each node that is in the fog; empty: all.
std::vector<float> fog_shares(const SourceGrid::Level& level, const FogBall& ball) {
  if (ball.is_endless()) return {};
  std::vector<float> shares(level.nodes.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double inside = ball.radius - glm::length(node_position(level, i) - ball.center);
    const double share = 0.5 + inside / static_cast<double>(level.nodes.spacing);
    shares[i] = static_cast<float>(std::clamp(share, 0.0, 1.0));
  }
  return shares;
}

// Times what a ball of fog transmits from each node on along w.
void attenuate_by_fog(const SourceGrid::Level& level, const SourceGrid::Content& content,
                      const glm::dvec3& w, std::span<float> transmittance) {
  const FogBall& ball = content.fog_ball;
  if (ball.is_endless()) return;
  for (std::size_t i = 0; i < transmittance.size(); ++i) {
    const double depth = content.fog_density * ball.length(node_position(level, i), w);
    transmittance[i] *= std::exp(-static_cast<float>(depth));
  }
}

// `coarse`: the level around this one; null if there is none.
Transmitted transmitted_light(const SourceGrid::Level& level, const SourceGrid::Level* coarse,
                              std::span<const SourceLight> lights, int bands, int clusters,
                              const SourceGrid::Content& content, const Job& job) {
  const std::size_t nodes = level.nodes.size();
  Transmitted result{NodeLight(bands, 3, nodes), {}, {}};
  const GridOcclusion* const surfaces = level.surfaces.get();
  if (surfaces) result.reflected.assign(3 * surfaces->surfels().size(), 0.0f);
  const std::size_t stride = result.light.stride;
  result.clusters.assign(static_cast<std::size_t>(clusters) * stride, 0.0f);
  std::vector<float> transmittances(std::min(sweep_batch, lights.size()) * stride, 0.0f);
  for (std::size_t first = 0; first < lights.size(); first += sweep_batch) {
    const auto current = lights.subspan(first, std::min(sweep_batch, lights.size() - first));
    const LightWeights weights(current, bands, clusters);
    job.parallel_for(current.size(), [&](std::size_t k) {
      thread_local std::vector<float> around;
      thread_local std::vector<float> inflow;
      const glm::dvec3& direction = current[k].light.direction;
      const glm::vec3 w(direction);
      const auto occlusion = [&](const SourceGrid::Level& of) {
        return occlusion_of(of, content.surfaces, direction);
      };
      inflow.clear();
      if (surfaces && coarse && !level.holds_surfaces) {
        around.resize(coarse->nodes.size());
        inflow.resize(nodes);
        sweep_transmittance(coarse->nodes, coarse->density, w, occlusion(*coarse), {}, around);
        level.inflow->apply(around, inflow);
      }
      const std::span<float> passes = std::span(transmittances).subspan(k * stride, nodes);
      sweep_transmittance(level.nodes, level.density, w, occlusion(level), inflow, passes);
      attenuate_by_fog(level, content, direction, passes);
    });
    for (std::size_t k = 0; surfaces && k < current.size(); ++k) {
      add_reflected(*surfaces, current[k].light,
                    std::span(transmittances).subspan(k * stride, nodes), result.reflected);
    }
    job.parallel_for((stride + node_block - 1) / node_block, [&](std::size_t b) {
      const std::size_t begin = b * node_block;
      const std::size_t end = std::min(begin + node_block, stride);
      add_weighted(transmittances, weights.light, 3 * result.light.functions(), stride, begin, end,
                   result.light.values);
      if (clusters > 0) {
        add_weighted(transmittances, weights.clusters, static_cast<std::size_t>(clusters), stride,
                     begin, end, result.clusters);
      }
    });
  }
  return result;
}

// `coarse`: see transmitted_light().
void fill(SourceGrid::Level& level, const SourceGrid::Level* coarse,
          std::span<const SourceLight> lights, const SourceGrid::Content& content, const Job& job) {
  const std::size_t nodes = level.nodes.size();
  const int clusters = content.bands > 1 ? source_clusters : 0;
  const int bands = content.receivers || content.surfaces ? grid_bands : content.bands;
  Transmitted transmitted = transmitted_light(level, coarse, lights, bands, clusters, content, job);
  const std::size_t stride = transmitted.light.stride;
  const std::size_t functions = sh_size(content.bands);
  const std::size_t size = SourceGrid::node_size(content.bands);
  level.values.assign(size * nodes, 0.0f);
  job.parallel_for((nodes + node_block - 1) / node_block, [&](std::size_t b) {
    for (std::size_t i = b * node_block; i < std::min((b + 1) * node_block, nodes); ++i) {
      float* node = level.values.data() + size * i;
      for (std::size_t f = 0; f < functions; ++f) {
        for (std::size_t c = 0; c < 3; ++c) node[4 * f + c] = transmitted.light.row(c, f)[i];
      }
      for (std::size_t f = 0; f < static_cast<std::size_t>(clusters); ++f) {
        node[4 * functions + f] = transmitted.clusters[f * stride + i];
      }
    }
  });
  if (content.receivers) {
    const bool is_ball = content.fog_density > 0.0 && !content.fog_ball.is_endless();
    level.incident = incident_light(
        level.nodes, is_ball ? level.density_with_fog(content.fog_density) : level.density,
        transmitted.light, content.receivers->optics, job);
  }
  if (content.keeps_transmitted) {
    level.transmitted = std::move(transmitted.light);
    level.reflected = std::move(transmitted.reflected);
  }
}

// Of the light that a Gaussian emits, what is not absorbed in itself, relative to what the grid
// would let out: there it is widened to the spacing, and thinner. A Gaussian of depth T through its
// center lets out Ein(T) / T.
double escaping_share(const GaussianTerm<double>& g, float spacing) {
  const double radius = mean_radius_of(g);
  const double share = std::min(radius / static_cast<double>(spacing), 1.0);
  const double depth = central_depth(g);
  if (share == 1.0 || !(depth > 0.0)) return 1.0;
  const double widened = depth * share * share;
  if (!(widened > 0.0)) return 1.0;
  return entire_exponential_integral(depth) * share * share / entire_exponential_integral(widened);
}

// Means over what is around the nodes of a level, weighted by density: of the Gaussians by
// weight(i), of fog and of nothing `of_rest`.
template <class Weight>
std::vector<float> node_means(std::span<const GaussianTerm<double>> gaussians, Weight weight,
                              float of_rest, double fog_density, const SourceGrid::Level& level,
                              const Job& job) {
  std::vector<GaussianTerm<double>> weighted(gaussians.begin(), gaussians.end());
  for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i].c *= weight(i);
  std::vector<float> means = density_on_grid(weighted, level.first, level.nodes, job);
  for (std::size_t i = 0; i < means.size(); ++i) {
    const float fog = static_cast<float>(fog_density) * (level.fog.empty() ? 1.0f : level.fog[i]);
    const float sum = level.density[i] + fog;
    means[i] = sum > 0.0f ? (means[i] + of_rest * fog) / sum : of_rest;
  }
  return means;
}

// Sets albedo and emission of a level from its density and fog.
void add_optics(std::span<const GaussianTerm<double>> gaussians, const SourceGrid::Content& content,
                SourceGrid::Level& level, const Job& job) {
  const std::vector<RelativeOptics> all = content.emission->held(
      [&](const EmissionLights::Light& light) { return level.is_point(light); });
  if (std::ranges::any_of(all, [](const RelativeOptics& own) { return own.albedo != 1.0; })) {
    const auto albedo = [&](std::size_t i) { return all[i].albedo; };
    level.albedo = node_means(gaussians, albedo, 1.0f, content.fog_density, level, job);
  }
  if (std::ranges::all_of(
          all, [](const RelativeOptics& own) { return own.emission == glm::dvec3(0.0); })) {
    return;
  }
  for (int c = 0; c < 3; ++c) {
    const auto emission = [&](std::size_t i) {
      return all[i].emission[c] * escaping_share(gaussians[i], level.nodes.spacing);
    };
    level.emission[static_cast<std::size_t>(c)] =
        node_means(gaussians, emission, 0.0f, content.fog_density, level, job);
  }
}

}  // namespace

SourceGrid::SourceGrid(std::span<const GaussianTerm<double>> gaussians,
                       std::span<const SourceLight> lights, const Content& content,
                       const SourceGridSize& size, const Job& job)
    : bands_(content.bands) {
  const GridLayout layout = lay_out_levels(gaussians, content, size);
  core_ = layout.core;
  for (const NodeLayout& nodes : layout.levels) {
    Level& level = levels_.emplace_back();
    level.first = nodes.first;
    level.nodes = nodes.nodes;
  }
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    Level& level = levels_[k];
    level.density = density_on_grid(gaussians, level.first, level.nodes, job);
    if (content.fog_density > 0.0) level.fog = fog_shares(level, content.fog_ball);
    if (content.surfaces) {
      level.surfaces = content.surfaces->at(k, level.first, level.nodes, job);
      const double rounding = 1e-3 * static_cast<double>(level.nodes.spacing);
      level.holds_surfaces = contains({level.first - rounding, last_position(level) + rounding},
                                      content.surfaces->bounds());
    }
    if (content.emission) add_optics(gaussians, content, level, job);
  }
  for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
    Level& level = levels_[k];
    const Level& coarse = levels_[k + 1];
    level.inflow.emplace(NodeLayout{coarse.first, coarse.nodes},
                         NodeLayout{level.first, level.nodes});
    if (!coarse.surfaces || level.holds_surfaces) continue;  // null, too, once the job is stopped
    level.inflow->see(content.surfaces->ray_caster(), coarse.surfaces->hidden(), job);
  }
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    fill(levels_[k], k + 1 < levels_.size() ? &levels_[k + 1] : nullptr, lights, content, job);
  }
}

std::vector<float> SourceGrid::Level::density_with_fog(double fog_density) const {
  std::vector<float> sum = density;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += static_cast<float>(fog_density) * (fog.empty() ? 1.0f : fog[i]);
  }
  return sum;
}

bool SourceGrid::Level::is_point(const EmissionLights::Light& light) const {
  return light.width <= 4.0 * static_cast<double>(nodes.spacing);
}

void SourceGrid::set_scattered(const Scattered& scattered, const Job& job) {
  const std::size_t size = node_size(bands_);
  const auto distant_scale = static_cast<float>(scattered.distant_scale);
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    Level& level = levels_[k];
    const NodeLight& light = scattered.levels[k];
    if (level.distant.empty()) level.distant = level.values;
    job.parallel_for((level.nodes.size() + node_block - 1) / node_block, [&](std::size_t b) {
      const std::size_t begin = b * node_block;
      const std::size_t end = std::min(begin + node_block, level.nodes.size());
      for (int l = 0; l < bands_; ++l) {
        const glm::vec3 scale =
            scattered.color * static_cast<float>(scattered.factors[static_cast<std::size_t>(l)]);
        for (std::size_t f = sh_size(l); f < sh_size(l + 1); ++f) {
          for (int c = 0; c < 3; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            const float* row = light.row(light.channels == 3 ? channel : 0, f).data();
            for (std::size_t i = begin; i < end; ++i) {
              const std::size_t at = size * i + 4 * f + channel;
              level.values[at] = distant_scale * level.distant[at] + scale[c] * row[i];
            }
          }
        }
      }
    });
  }
  revision_ = new_revision();
}

void SourceGrid::set_incident(const Scattered& scattered, const Job& job) {
  const auto distant_scale = static_cast<float>(scattered.distant_scale);
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    Level& level = levels_[k];
    const NodeLight& light = scattered.levels[k];
    const std::size_t functions = sh_size(grid_bands);
    level.incident.assign(4 * functions * level.nodes.size(), 0.0f);
    job.parallel_for((level.nodes.size() + node_block - 1) / node_block, [&](std::size_t b) {
      const std::size_t begin = b * node_block;
      const std::size_t end = std::min(begin + node_block, level.nodes.size());
      for (std::size_t f = 0; f < functions; ++f) {
        for (std::size_t c = 0; c < 3; ++c) {
          const float* transmitted = level.transmitted.row(c, f).data();
          const float* row = light.row(light.channels == 3 ? c : 0, f).data();
          const float color = scattered.color[static_cast<int>(c)];
          for (std::size_t i = begin; i < end; ++i) {
            level.incident[4 * (functions * i + f) + c] =
                distant_scale * transmitted[i] + color * row[i];
          }
        }
      }
    });
  }
  revision_ = new_revision();
}

void SourceGrid::remove_scattered() {
  for (Level& level : levels_) {
    level.values = std::move(level.distant);
    level.distant.clear();
  }
  revision_ = new_revision();
}

std::size_t SourceGrid::bytes() const {
  std::size_t floats = 0;
  for (const Level& level : levels_) {
    floats += level.density.size() + level.fog.size() + level.values.size() + level.distant.size() +
              level.incident.size() + level.transmitted.values.size() + level.reflected.size() +
              level.albedo.size() + 3 * level.emission[0].size();
  }
  return sizeof(float) * floats;
}

bool SourceGrid::holds(const Box& box) const {
  return contains(core_, box);
}

}  // namespace brume
