#include "render/scattering/source_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"
#include "render/simd/gaussian_kernels.h"
#include "render/simd/phase_kernels.h"

namespace brume {
namespace {

using std::numbers::pi;

// So many times as many directions of light that comes through windows: what these let in is lit by
// few of all.
constexpr std::size_t directions_through_windows = 4;

// In rows as fine as the phase function is narrow, 2 R columns of R rows.
RadianceMap empty_map(double anisotropy) {
  const int rows =
      std::clamp(static_cast<int>(std::ceil(pi / (0.25 * (1.0 - std::abs(anisotropy))))), 24, 64);
  RadianceMap map{2 * rows, rows, {}};
  map.pixels.resize(static_cast<std::size_t>(2 * rows * rows));
  return map;
}

// Forward-lobe scattering of a cluster for each direction: full phase function minus the grid's
// bands of its lights.
std::shared_ptr<const RadianceMap> scattered_by_forward_lobe(
    const PhaseBands& bands, double anisotropy, std::span<const LightGroup* const> cluster,
    const Job& job) {
  std::vector<PhasedLight> phased_lights;
  for (const LightGroup* group : cluster) {
    for (const DistantLight& light : group->lights)
      phased_lights.push_back({light.direction, light.irradiance});
  }
  auto map = std::make_shared<RadianceMap>(empty_map(anisotropy));
  const auto width = static_cast<std::size_t>(map->width);
  job.parallel_for(static_cast<std::size_t>(map->height), [&](std::size_t y) {
    std::array<std::vector<float>, 3> w;
    std::array<std::vector<float>, 3> sums;
    w.fill(std::vector<float>(padded(width), 0.0f));
    sums.fill(std::vector<float>(padded(width), 0.0f));
    for (std::size_t x = 0; x < width; ++x) {
      const glm::dvec3 direction =
          map_direction(*map, {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5});
      glm::dvec3 in_bands(0.0);
      for (const LightGroup* group : cluster) {
        const DistantLight& combined = group->combined;
        in_bands += bands.phase(glm::dot(direction, combined.direction)) * combined.irradiance;
      }
      for (int c = 0; c < 3; ++c) {
        const auto k = static_cast<std::size_t>(c);
        w[k][x] = static_cast<float>(direction[c]);
        sums[k][x] = static_cast<float>(-in_bands[c]);
      }
    }
    add_phased(phased_lights, anisotropy, {w[0], w[1], w[2]}, {sums[0], sums[1], sums[2]});
    for (std::size_t x = 0; x < width; ++x) {
      map->pixels[y * width + x] = {sums[0][x], sums[1][x], sums[2][x]};
    }
  });
  return map;
}

double power(const DistantLight& light) {
  return light.irradiance.x + light.irradiance.y + light.irradiance.z;
}

// Whether the light comes from within 14 degrees or so (rms) of one direction.
bool is_narrow(std::span<const LightGroup* const> cluster) {
  constexpr double min_resultant = 0.97;
  double sum = 0.0;
  glm::dvec3 moment(0.0);
  for (const LightGroup* group : cluster) {
    for (const DistantLight& light : group->lights) {
      sum += power(light);
      moment += power(light) * light.direction;
    }
  }
  return glm::length(moment) > min_resultant * sum;
}

// Adds the lights of a cluster to a map as coarse as they are.
void add_radiance(std::span<const LightGroup* const> cluster, RadianceMap& map) {
  for (const LightGroup* group : cluster) {
    for (const DistantLight& light : group->lights) {
      const glm::ivec2 cell = glm::min(glm::ivec2(map_position(map, light.direction)),
                                       glm::ivec2(map.width, map.height) - 1);
      const double solid_angle =
          2.0 * pi / map.width *
          (std::cos(pi * cell.y / map.height) - std::cos(pi * (cell.y + 1) / map.height));
      map.pixels[static_cast<std::size_t>(cell.y * map.width + cell.x)] +=
          light.irradiance / solid_angle;
    }
  }
}

}  // namespace

void SourceFunction::clear() {
  grid_.reset();
  multiple_.clear();
  added_ = 0;
}

bool SourceFunction::update(const Input& input, const Job& job,
                            const std::function<void()>& grid_is_made) {
  bool is_complete = make_grid(input, job);
  // Nodes hold how much passes the fog if light is scattered in it more than once.
  attenuation_ = input.multiple ? 1.0 : std::exp(-input.fog_depth);
  lobe_attenuation_ = attenuation_;
  if (input.multiple && input.anisotropy > 0.0) {
    lobe_attenuation_ = std::exp(-extinction_ * input.view_fog_depth);
  }
  for (std::size_t f = 0; f < at_nodes_.size(); ++f) {
    at_nodes_[f] = light_.is_narrow[f] || surfaces_revision_ != 0;
  }
  has_lobe_on_rays_ = has_forward_lobe() && std::ranges::find(at_nodes_, false) != at_nodes_.end();
  if (is_complete) {
    if (grid_is_made) grid_is_made();
    is_complete = add_multiple(input, job);
  }
  if (!is_complete) clear();
  return is_complete;
}

bool SourceFunction::make_grid(const Input& input, const Job& job) {
  const Environment* const environment = input.environment;
  const bool same_map = environment ? environment_ && environment_->map == environment->map
                                    : !environment_.has_value();
  phase_ = PhaseBands(input.anisotropy);
  const double extinction = input.multiple
                                ? TruncatedScattering(input.multiple->albedo, input.anisotropy,
                                                      phase_.count(), input.medium.has_albedos())
                                      .extinction
                                : 1.0;
  LevelOcclusion* surfaces = nullptr;
  if (input.multiple && input.multiple->ray_caster) {
    surfaces = &occlusion_;
    occlusion_.set(*input.multiple->ray_caster, input.multiple->surfaces);
  }
  const bool through_windows = input.multiple && input.multiple->through_windows;
  const Revision surfaces_revision = surfaces ? occlusion_.revision() : 0;
  const Revision emission = input.multiple ? input.multiple->emission->revision() : 0;
  const bool same_light =
      grid_ && same_map && anisotropy_ == input.anisotropy && size_ == input.size;
  const bool same = same_light &&
                    (!environment || environment_->rotation == environment->rotation) &&
                    has_same(input.receivers) && scene_medium_ == input.scene_medium &&
                    (input.motion.any_source_precision ||
                     (medium_ == input.medium.revision() && emission_ == emission)) &&
                    fog_ball_ == input.fog_ball && lit_ == input.lit && extinction_ == extinction &&
                    keeps_transmitted_ == input.multiple.has_value() &&
                    surfaces_revision_ == surfaces_revision && through_windows_ == through_windows;
  environment_.reset();
  if (environment) environment_ = *environment;
  if (same) return true;
  if (!environment) {
    light_ = {};
  } else {
    const std::size_t more = through_windows ? directions_through_windows : 1;
    read_map(environment->map, input.anisotropy, more * input.size.directions, job);
  }
  medium_ = input.medium.revision();
  scene_medium_ = input.scene_medium;
  fog_ball_ = input.fog_ball;
  lit_ = input.lit;
  extinction_ = extinction;
  albedo_ = input.multiple ? input.multiple->albedo : 1.0;
  lobe_broadening_ =
      extinction < 1.0 ? LobeBroadening(input.anisotropy, PhaseBands::max_bands) : LobeBroadening();
  keeps_transmitted_ = input.multiple.has_value();
  emission_ = emission;
  surfaces_revision_ = surfaces_revision;
  through_windows_ = through_windows;
  anisotropy_ = input.anisotropy;
  receivers_ = input.receivers;
  size_ = input.size;

  const GaussianTerms<double> terms(input.medium, extinction);
  grid_.emplace(terms.all(), lights_in_world(),
                SourceGrid::Content{phase_.count(), extinction * input.medium.homogeneous_density(),
                                    input.fog_ball, input.lit, receivers_, surfaces,
                                    input.multiple.has_value(),
                                    input.multiple ? input.multiple->emission : nullptr},
                input.size, job);
  added_ = 0;
  return !job.stop.stop_requested();
}

std::vector<SourceLight> SourceFunction::lights_in_world() const {
  std::vector<SourceLight> lights = light_.lights;
  for (SourceLight& light : lights) {
    light.light.direction = environment_rotation(*environment_) * light.light.direction;
  }
  return lights;
}

bool SourceFunction::add_multiple(const Input& input, const Job& job) {
  if (!input.multiple) {
    multiple_.clear();
    eye_lobe_ = {};
    if (has_multiple()) grid_->remove_scattered();
    added_ = 0;
    return true;
  }
  const Multiple& multiple = *input.multiple;
  const double scale = weight_parts(nullptr).scale;
  if (!multiple_.update(
          {*grid_, environment_ ? scale : 0.0, multiple.lights, multiple.emission->lights(),
           multiple.albedo, anisotropy_, input.medium.homogeneous_density(),
           input.fog_ball.is_endless(), multiple.ray_caster, occlusion_.revision(), multiple.limits,
           input.motion, multiple.through_windows},
          job)) {
    return false;
  }
  const bool is_added = added_ == multiple_.revision() && added_scale_ == scale;
  find_eye_lobe(input, is_added, job);
  if (is_added) return true;
  // Look-ups multiply by bands without the forward lobe.
  std::vector<double> factors(static_cast<std::size_t>(phase_.count()), 1.0);
  if (extinction_ == 1.0) {
    const std::vector<double> whole = phase_bands(anisotropy_, phase_.count());
    for (std::size_t l = 0; l < factors.size(); ++l) factors[l] = whole[l] / phase_.factors()[l];
  }
  const SourceGrid::Scattered scattered{multiple_.levels(), multiple_.color(), factors,
                                        environment_ ? scale : 0.0};
  grid_->set_scattered(scattered, job);
  if (multiple.ray_caster) grid_->set_incident(scattered, job);
  added_ = multiple_.revision();
  added_scale_ = scale;
  return !job.stop.stop_requested();
}

void SourceFunction::find_eye_lobe(const Input& input, bool is_same_light, const Job& job) {
  const Multiple& multiple = *input.multiple;
  if (!multiple.ray_caster || extinction_ == 1.0) {
    eye_lobe_ = {};
    return;
  }
  const View view{multiple.view->eye(), multiple.view->plane(), multiple.view->whole_size()};
  if (is_same_light && view_ == view) return;
  view_ = view;
  eye_lobe_ = EyeLobe(
      *grid_,
      {*multiple.ray_caster, multiple.surfaces, multiple_.reflected(),
       multiple_.levels().front().channels, multiple_.color()},
      lobed_sky(), {anisotropy_, extinction_, input.medium.homogeneous_density(), input.fog_ball},
      *multiple.view, job);
  if (job.stop.stop_requested()) {
    eye_lobe_ = {};
    view_ = {};
  }
}

// Of where receivers are only that counts which decides on the grid.
bool SourceFunction::has_same(const std::optional<SourceGrid::Receivers>& receivers) const {
  if (!receivers_ || !receivers) return receivers_.has_value() == receivers.has_value();
  return receivers_->optics == receivers->optics &&
         grid_->holds(receivers_->box) == grid_->holds(receivers->box);
}

void SourceFunction::read_map(const std::shared_ptr<const RadianceMap>& map, double anisotropy,
                              std::size_t directions, const Job& job) {
  const auto is_wanted = [&](const MapLight& light) {
    return light.map == map && light.anisotropy == anisotropy && light.directions == directions;
  };
  if (is_wanted(light_)) return;
  std::swap(light_, last_light_);
  if (is_wanted(light_)) return;
  light_ = {.map = map, .anisotropy = anisotropy, .directions = directions};
  const std::vector<LightGroup> groups = distant_light_groups(
      *map, {.groups = directions, .clusters = static_cast<std::size_t>(source_clusters)});
  std::array<double, source_clusters> powers{};
  for (const LightGroup& group : groups) {
    powers[static_cast<std::size_t>(group.cluster)] += power(group.combined);
  }
  for (const LightGroup& group : groups) {
    const double group_power = power(group.combined);
    light_.lights.push_back({group.combined, group.cluster,
                             group_power / powers[static_cast<std::size_t>(group.cluster)]});
    light_.power += group_power;
  }
  if (phase_.count() > 1) find_forward_lobes(groups, job);
  if (job.stop.stop_requested()) light_ = {};
}

void SourceFunction::find_forward_lobes(std::span<const LightGroup> groups, const Job& job) {
  light_.wide = {2 * distant_light_rows, distant_light_rows, {}};
  light_.wide.pixels.resize(static_cast<std::size_t>(light_.wide.width * light_.wide.height));
  for (std::size_t cluster = 0; cluster < source_clusters; ++cluster) {
    std::vector<const LightGroup*> members;
    for (const LightGroup& group : groups) {
      if (group.cluster == static_cast<int>(cluster)) members.push_back(&group);
    }
    light_.lobes.push_back(scattered_by_forward_lobe(phase_, light_.anisotropy, members, job));
    light_.is_narrow[cluster] = is_narrow(members);
    if (!light_.is_narrow[cluster]) add_radiance(members, light_.wide);
  }
}

LobedSky SourceFunction::lobed_sky() const {
  if (!environment_) return {};
  LobedSky sky{light_.wide,
               {},
               glm::mat3_cast(glm::conjugate(environment_rotation(*environment_))),
               weight_parts(nullptr).scale};
  for (std::size_t f = 0; f < light_.lobes.size(); ++f) {
    if (!light_.is_narrow[f]) sky.scattered.push_back(light_.lobes[f]);
  }
  return sky;
}

SourceLookup SourceFunction::from_eye(const glm::dvec3& eye, const EyeLobe* lobe) const {
  const bool adds_clusters =
      has_forward_lobe() && std::ranges::count(weight_parts(lobe).at_nodes, true) != 0;
  return {*grid_, eye, adds_clusters, NodeVisibility(*grid_, eye)};
}

SourceFunction::WeightParts SourceFunction::weight_parts(const EyeLobe* lobe) const {
  if (!environment_) return {1.0, 1.0, 1.0, phase_.factors(), {}, at_nodes_, 0.0};
  // Sums of what is beyond float would not be numbers.
  const double max_scale = 1e30 / std::max(light_.power, 1e-30);
  const double scale = std::min(attenuation_ * environment_->intensity, max_scale);
  const bool has_eye_lobe = lobe && !lobe->empty();
  return {scale,
          has_eye_lobe ? 0.0 : std::min(lobe_attenuation_ * environment_->intensity, max_scale),
          has_multiple() ? 1.0 : scale,
          phase_.factors(),
          light_.lobes,
          has_eye_lobe ? light_.is_narrow : at_nodes_,
          environment_->rotation};
}

glm::vec3 SourceFunction::lobe(const SourceLookup& source, const SourceWeights& weights,
                               float line_depth) const {
  SourceLookup::ClusterTransmittance passes;
  if (anisotropy_ > 0.0) {
    passes.fill(std::exp(-static_cast<float>(extinction_) * line_depth));
  } else {
    passes = source.cluster_transmittance();
  }
  glm::vec3 sum(0.0f);
  for (std::size_t f = 0; f < passes.size(); ++f) sum += passes[f] * weights.on_rays[f];
  return sum;
}

glm::vec3 SourceFunction::lobe_on_ray(const SourceLookup& source, const SourceWeights& weights,
                                      float line_depth, const TileRays& rays, std::size_t k) const {
  if (rays.offsets.empty() || anisotropy_ > 0.0) return lobe(source, weights, line_depth);
  return lobe(from_eye(rays.origin(k)), weights, line_depth);
}

SourceWeights SourceFunction::weights(const glm::dvec3& w, const EyeLobe* lobe) const {
  const WeightParts parts = weight_parts(lobe);
  const auto bands = phase_.at(w);
  SourceWeights weights;
  for (std::size_t i = 0; i < sh_size(phase_.count()); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      weights.harmonics[4 * i + c] =
          static_cast<float>(parts.harmonics_scale * static_cast<double>(bands[i]));
    }
  }
  if (light_.lobes.empty()) return weights;
  const glm::vec3 in_map(glm::conjugate(environment_rotation(*environment_)) * w);
  for (std::size_t f = 0; f < light_.lobes.size(); ++f) {
    const glm::vec3 scattered = map_radiance(*light_.lobes[f], in_map);
    if (parts.at_nodes[f]) {
      weights.at_nodes[f] = static_cast<float>(parts.scale) * scattered;
    } else {
      weights.on_rays[f] = static_cast<float>(parts.lobe_scale) * scattered;
    }
  }
  return weights;
}

SliceScattering slice_scattering(double anisotropy, const SourceFunction* source) {
  SliceScattering scattering{.anisotropy = static_cast<float>(anisotropy)};
  if (!source) return scattering;
  scattering.view_extinction = static_cast<float>(source->light_extinction());
  std::ranges::transform(source->phase().phase_powers(), scattering.truncated_phase.begin(),
                         [](double power) { return static_cast<float>(power); });
  if (!source->lobe_broadening().empty())
    scattering.lobe_broadening = source->lobe_broadening().values().data();
  scattering.albedo = static_cast<float>(source->albedo());
  return scattering;
}

}  // namespace brume
