#include "render/scattering/multiple_scattering.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "render/grid/resampling.h"
#include "render/grid/sweep_kernels.h"
#include "render/scattering/mirrored_point_light.h"

namespace brume {
namespace {

// Bands in which scattered light is kept: surfaces reflect more than isotropic media scatter.
int solution_bands(const MultipleScattering::Input& input) {
  return input.anisotropy == 0.0 && !input.surfaces ? 1 : grid_bands;
}

// The colour of all light if it is the same and stays: then one channel is enough.
std::optional<glm::vec3> common_color(const MultipleScattering::Input& input) {
  if (input.environment_scale > 0.0) return std::nullopt;
  for (const SourceGrid::Level& level : input.grid.levels()) {
    if (!level.emission[0].empty()) return std::nullopt;
    if (level.surfaces && !level.surfaces->is_grey()) return std::nullopt;
  }
  glm::dvec3 color(0.0);
  const auto is_common = [&](const glm::dvec3& intensity) {
    const double max = std::max({intensity.x, intensity.y, intensity.z});
    if (!(max > 0.0)) return true;
    const glm::dvec3 own = intensity / max;
    if (color == glm::dvec3(0.0)) color = own;
    return glm::all(glm::lessThan(glm::abs(own - color), glm::dvec3(1e-9)));
  };
  for (const MultipleScattering::Light& light : input.lights) {
    if (!is_common(light.intensity)) return std::nullopt;
  }
  for (const EmissionLights::Light& light : input.emission) {
    if (!is_common(light.source.intensity)) return std::nullopt;
  }
  return glm::vec3(color);
}

NodeLight resampled(const NodeLight& light, const Resampling& resampling, std::size_t nodes,
                    const Job& job) {
  NodeLight result(light.bands, light.channels, nodes);
  job.parallel_for(light.channels * light.functions(), [&](std::size_t row) {
    const std::size_t c = row / light.functions();
    const std::size_t f = row % light.functions();
    resampling.apply(light.row(c, f), result.row(c, f).first(nodes));
  });
  return result;
}

// The environment's unscattered light at the nodes of a level, times `scale`.
void add_environment(const SourceGrid::Level& level, double scale, NodeLight& light) {
  const auto factor = static_cast<float>(scale);
  for (std::size_t c = 0; c < light.channels; ++c) {
    for (std::size_t f = 0; f < light.functions(); ++f) {
      const std::span<float> row = light.row(c, f);
      const std::span<const float> input = level.transmitted.row(c, f);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * input[i];
    }
  }
}

// In one channel the colour of all lights is common.
void set_intensity(NodePointLight& point, std::size_t channels) {
  const glm::vec3 intensity(point.source.intensity);
  point.intensity = {intensity.x, intensity.y, intensity.z};
  if (channels == 1) point.intensity[0] = std::max({intensity.x, intensity.y, intensity.z});
}

// Adds a light's that is unscattered, or reflected by surfaces then.
void add_light(NodePointLight point, const SourceGrid::Level& level, UnscatteredLight& light,
               const Job& job) {
  const std::size_t channels = light.incident.channels;
  set_intensity(point, channels);
  add_point_light(point, level.first, level.nodes, level.surfaces.get(), light.incident, job);
  if (!level.surfaces) return;
  add_reflected_point_light(point, *level.surfaces, level.first, level.nodes, light.reflected,
                            channels, job);
}

// Unscattered light in a level, in a medium whose extinction is `extinction` times that of the
// lights' tables.
UnscatteredLight unscattered_light(const MultipleScattering::Input& input, std::size_t k,
                                   double extinction, const std::optional<glm::vec3>& color,
                                   const Job& job) {
  const SourceGrid::Level& level = input.grid.levels()[k];
  UnscatteredLight light{NodeLight(solution_bands(input), color ? 1 : 3, level.nodes.size()), {}};
  const std::size_t channels = light.incident.channels;
  if (level.surfaces) light.reflected.assign(channels * level.surfaces->surfels().size(), 0.0f);
  if (input.environment_scale > 0.0) {
    add_environment(level, input.environment_scale, light.incident);
    for (std::size_t i = 0; i < light.reflected.size(); ++i) {
      light.reflected[i] += static_cast<float>(input.environment_scale) * level.reflected[i];
    }
  }
  for (const MultipleScattering::Light& source : input.lights) {
    add_light(
        {source, {}, source.table, extinction, extinction * input.fog_density, input.surfaces},
        level, light, job);
  }
  return light;
}

// Light that the Gaussians of a level emit and its nodes hold.
void add_held_emission(const MultipleScattering::Input& input, const SourceGrid::Level& level,
                       const GridMedium& medium, double extinction, UnscatteredLight& light,
                       const Job& job) {
  // As light that arrives from everywhere would be scattered; emission is divided by the albedo.
  NodeLight sent(1, 3, level.nodes.size());
  const double mean_of_band = 2.0 * std::sqrt(std::numbers::pi);
  const auto factor = static_cast<float>(input.albedo / extinction * mean_of_band);
  for (std::size_t c = 0; c < 3; ++c) {
    std::ranges::transform(level.emission[c], sent.row(c, 0).begin(),
                           [factor](float x) { return factor * x; });
  }
  GridMedium emitting = medium;
  emitting.albedo = {};
  const std::vector<float> dark(light.reflected.size(), 0.0f);
  scatter_once(emitting, sent, dark, std::vector{1.0}, input.limits.light_degree, light.incident,
               job);
  if (level.surfaces) light.reflected = reflected_light(*level.surfaces, light.incident);
}

// The light of point lights that smooth surfaces mirror, as it arrives unscattered at the nodes of
// a level, and as surfaces reflect it then.
void add_mirrored_light(const MultipleScattering::Input& input, const SourceGrid::Level& level,
                        double extinction, UnscatteredLight& light, const Job& job) {
  NodeLight mirrored(light.incident.bands, light.incident.channels, level.nodes.size());
  for (const MultipleScattering::Light& source : input.lights) {
    NodePointLight point{
        source, {}, source.table, extinction, extinction * input.fog_density, input.surfaces};
    set_intensity(point, mirrored.channels);
    add_mirrored_point_light(point, *level.surfaces, level.first, level.nodes, mirrored, job);
  }
  add(mirrored.values, light.incident.values);
  add(reflected_light(*level.surfaces, mirrored), light.reflected);
}

// Light that arrives unscattered at the nodes of a level and that slices do not know: what
// Gaussians emit, and what smooth surfaces mirror; and as surfaces reflect it.
std::optional<UnscatteredLight> light_of_nodes(const MultipleScattering::Input& input,
                                               const SourceGrid::Level& level,
                                               const GridMedium& medium, double extinction,
                                               const UnscatteredLight& others, const Job& job) {
  const auto is_point = [&](const EmissionLights::Light& emission) {
    return level.is_point(emission);
  };
  const bool is_held = !level.emission[0].empty();
  const bool has_mirrors = level.surfaces && !level.surfaces->mirrors().empty();
  if (!is_held && !has_mirrors && std::ranges::none_of(input.emission, is_point)) {
    return std::nullopt;
  }
  UnscatteredLight light{
      NodeLight(others.incident.bands, others.incident.channels, level.nodes.size()),
      std::vector<float>(others.reflected.size(), 0.0f)};
  if (is_held) add_held_emission(input, level, medium, extinction, light, job);
  if (has_mirrors) add_mirrored_light(input, level, extinction, light, job);
  for (const EmissionLights::Light& emission : input.emission) {
    if (!is_point(emission)) continue;
    add_light({emission.source,
               {},
               emission.table.get(),
               extinction,
               extinction * input.fog_density,
               input.surfaces,
               0.5 * emission.width},
              level, light, job);
  }
  return light;
}

// Whether a point is in the bounds of a level, at least `margin` from its border.
bool holds(const SourceGrid::Level& level, const glm::dvec3& p, double margin) {
  const glm::dvec3 high =
      level.first + glm::dvec3(level.nodes.count - 1) * static_cast<double>(level.nodes.spacing);
  return !glm::any(glm::lessThan(p, level.first + margin)) &&
         !glm::any(glm::greaterThan(p, high - margin));
}

// Removes what a level sends within the finer one. That of the outermost nodes there stays, since
// what goes in at the border is interpolated between them and nodes outside: without it up to half
// a cell of fog, and of floors that cross the border, would be lost all around.
void remove_within(const SourceGrid::Level& finer, const SourceGrid::Level& level,
                   UnscatteredLight& light) {
  const double spacing = static_cast<double>(level.nodes.spacing);
  const auto is_within = [&](std::size_t node) {
    const glm::dvec3 place(node_coordinates(level.nodes, node));
    return holds(finer, level.first + spacing * place, spacing);
  };
  NodeLight& incident = light.incident;
  for (std::size_t i = 0; i < level.nodes.size(); ++i) {
    if (!is_within(i)) continue;
    for (std::size_t row = 0; row < incident.channels * incident.functions(); ++row) {
      incident.values[row * incident.stride + i] = 0.0f;
    }
  }
  if (!level.surfaces) return;
  const GridOcclusion& surfaces = *level.surfaces;
  const std::size_t links = surfaces.surfels().size();
  for (std::size_t i = 0; i < surfaces.nodes().size(); ++i) {
    if (!is_within(surfaces.grid_nodes()[i])) continue;
    for (std::size_t c = 0; c < incident.channels; ++c) {
      const std::size_t first = c * links + surfaces.nodes()[i].first;
      std::fill_n(light.reflected.begin() + static_cast<std::ptrdiff_t>(first),
                  surfaces.surfels_of(i).size(), 0.0f);
    }
  }
}

// Whether a light is among nodes that scatter.
bool is_in_medium(const SourceGrid::Level& level, double fog, const glm::dvec3& light) {
  const glm::dvec3 coordinate =
      (light - level.first) / static_cast<double>(level.nodes.spacing) + 0.5;
  const glm::ivec3 node(glm::floor(coordinate));
  if (glm::any(glm::lessThan(node, glm::ivec3(0))) ||
      glm::any(glm::greaterThanEqual(node, level.nodes.count))) {
    return false;
  }
  const std::size_t at = node_index(level.nodes, node);
  return static_cast<double>(level.density[at]) + fog > 0.0;
}

// The middle of the scene's lights and of those that Gaussians emit, by their power.
glm::dvec3 middle_of_lights(const MultipleScattering::Input& input) {
  glm::dvec3 sum(0.0);
  double all = 0.0;
  const auto add = [&](const PointSource& light) {
    const double power = light.intensity.x + light.intensity.y + light.intensity.z;
    sum += power * light.position;
    all += power;
  };
  std::ranges::for_each(input.lights, add);
  for (const EmissionLights::Light& light : input.emission) add(light.source);
  return all > 0.0 ? sum / all : sum;
}

SweepDegrees sweep_degrees(const MultipleScattering::Input& input, const SourceGrid::Level& level) {
  SweepDegrees degrees{input.limits.degree, input.limits.degree};
  if (input.surfaces) degrees.first = std::max(degrees.first, input.limits.light_degree);
  const auto add = [&](const PointSource& light) {
    if (is_in_medium(level, input.fog_density, light.position)) {
      degrees.first = std::max(degrees.first, input.limits.light_degree);
    }
  };
  std::ranges::for_each(input.lights, add);
  for (const EmissionLights::Light& light : input.emission) {
    if (level.is_point(light)) add(light.source);
  }
  return degrees;
}

}  // namespace

std::size_t MultipleScattering::bytes() const {
  std::size_t floats = 0;
  for (const NodeLight& level : levels_) floats += level.values.size();
  for (const std::vector<float>& level : reflected_) floats += level.size();
  for (const std::optional<Solution>& solution : solutions_) {
    if (solution) floats += solution->scattered.values.size();
  }
  return sizeof(float) * floats;
}

void MultipleScattering::clear() {
  *this = MultipleScattering();
}

bool MultipleScattering::Key::is_but_for_tables(const Key& other) const {
  Key mine = *this;
  Key its = other;
  for (Key* key : {&mine, &its}) {
    for (LightKey& light : key->lights) light.table = 0;
  }
  return mine == its;
}

bool MultipleScattering::update(const Input& input, const Job& job) {
  Key key{input.grid.distant_revision(),
          input.environment_scale,
          {},
          input.albedo,
          input.anisotropy,
          input.fog_density,
          input.fog_is_endless,
          input.surfaces_revision,
          input.limits,
          input.motion.warm_start,
          input.through_windows};
  for (const Light& light : input.lights) {
    key.lights.push_back({light.position, light.intensity,
                          light.table ? light.table->revision() : 0, light.falloff, light.fog});
  }
  for (const EmissionLights::Light& light : input.emission) {
    key.lights.push_back(
        {light.source.position, light.source.intensity, light.table->revision(), {}, {}});
  }
  if (!levels_.empty() &&
      (key == key_ || (input.motion.any_source_precision && key.is_but_for_tables(key_)))) {
    return true;
  }
  key_ = std::move(key);
  levels_.clear();
  const std::optional<glm::vec3> color = common_color(input);
  color_ = color.value_or(glm::vec3(1.0f));

  const auto levels = input.grid.levels();
  const TruncatedScattering truncation(input.albedo, input.anisotropy,
                                       input.anisotropy == 0.0 ? 1 : grid_bands,
                                       !levels.front().albedo.empty());
  const auto is_zero = [](float density) { return density == 0.0f; };
  std::vector<std::vector<float>> extinctions;
  std::vector<GridMedium> media;
  for (const SourceGrid::Level& level : levels) {
    extinctions.push_back(level.density_with_fog(truncation.extinction * input.fog_density));
    const bool is_outermost = media.size() + 1 == levels.size();
    std::optional<EndlessFog> beyond;
    if (is_outermost && input.fog_is_endless && input.fog_density > 0.0) {
      beyond.emplace(input.fog_density, input.albedo, input.anisotropy,
                     middle_of_lights(input) - level.first);
    }
    media.push_back({.nodes = level.nodes,
                     .density = extinctions.back(),
                     .continues = !is_outermost || beyond,
                     .surfaces = level.surfaces.get(),
                     .albedo = level.albedo,
                     .is_fog_alone = std::ranges::all_of(level.density, is_zero),
                     .beyond = beyond});
  }
  std::vector<double> phase = truncation.phase;
  for (double& factor : phase) factor *= truncation.albedo;
  solutions_.resize(levels.size());
  reflected_.assign(levels.size(), {});
  std::vector<NodeLight> solved(levels.size());
  std::vector<OuterLevel> outer;  // the finest first
  for (std::size_t k = levels.size(); k-- > 0;) {
    const SourceGrid::Level& level = levels[k];
    const SweepDegrees degrees = sweep_degrees(input, level);
    UnscatteredLight light = unscattered_light(input, k, truncation.extinction, color, job);
    const std::optional<UnscatteredLight> own =
        light_of_nodes(input, level, media[k], truncation.extinction, light, job);
    if (own) {
      add(own->incident.values, light.incident.values);
      add(own->reflected, light.reflected);
    }
    std::optional<NodeLight> outside;
    if (!outer.empty()) {
      const int degree = input.through_windows ? degrees.first : degrees.rest;
      outside = scatter_into(media[k], outer, phase, degree, job);
      add(outside->values, light.incident.values);
      if (level.surfaces) add(reflected_light(*level.surfaces, *outside), light.reflected);
    }
    NodeLight scattered;
    if (input.motion.warm_start) {
      scattered = first_guess(k, level, light.incident.bands, light.incident.channels);
    }
    convergence_ =
        solve_scattering(media[k], truncation, light, degrees, input.limits, scattered, job);
    if (job.stop.stop_requested()) {
      clear();
      return false;
    }
    solutions_[k] = Solution{level.first, level.nodes, scattered};
    // All orders count for the levels within, and for what the forward lobe scatters to the eye.
    const bool has_lobe = truncation.extinction < 1.0;
    if (level.surfaces && (k > 0 || has_lobe)) {
      add(reflected_light(*level.surfaces, scattered), light.reflected);
    }
    if (has_lobe) reflected_[k] = light.reflected;
    if (k > 0) {
      add(scattered.values, light.incident.values);
      const SourceGrid::Level& finer = levels[k - 1];
      remove_within(finer, level, light);
      GridMedium around = media[k];
      if (finer.holds_surfaces) {
        // Coarse nodes behind its walls would darken its border.
        around.surfaces = nullptr;
        light.reflected.clear();
      }
      outer.insert(outer.begin(),
                   {around, std::move(light.incident), std::move(light.reflected), &*finer.inflow});
    }
    if (outside) add(outside->values, scattered.values);
    if (own) add(own->incident.values, scattered.values);
    solved[k] = std::move(scattered);
  }
  levels_ = std::move(solved);
  revision_ = new_revision();
  return true;
}

NodeLight MultipleScattering::first_guess(std::size_t k, const SourceGrid::Level& level, int bands,
                                          std::size_t channels) const {
  const std::optional<Solution>& last = solutions_[k];
  if (!last || last->scattered.bands != bands || last->scattered.channels != channels) return {};
  return resampled(last->scattered,
                   Resampling({last->first, last->nodes}, {level.first, level.nodes}),
                   level.nodes.size(), {});
}

}  // namespace brume
