#include "render/prepare/frame_stages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "render/geometry/tiles.h"
#include "render/prepare/light_limits.h"

namespace brume {

void FrameContext::make_layers() {
  const auto pixels =
      static_cast<std::size_t>(frame.film.width) * static_cast<std::size_t>(frame.film.height);
  // Filled in parallel. Not cancellable: later stages rely on the layers even after a stop.
  const std::array<std::function<void()>, 5> layers{
      [&] { frame.beauty.resize(4 * pixels); }, [&] { frame.airlight.resize(3 * pixels); },
      [&] { frame.transmittance.assign(3 * pixels, 1.0f); },
      [&] { frame.depth.assign(pixels, std::numeric_limits<float>::infinity()); },
      [&] {
        if (plan.has_medium()) frame.statistics.pixel_pairs.resize(pixels);
      }};
  Job().parallel_for(layers.size(), [&](std::size_t i) { layers[i](); });
}

bool FrameStages::begin(FrameContext& work, StageClock& clock) {
  if (work.plan.runs(Stage::transfer)) {
    if (!make_transfers(work)) return false;
    clock.finish(Stage::transfer);
  }
  if (!prepared_.update(work.scene, work.plan, work.fog_extent.fog(), work.job.stop,
                        channel_weights(work.group))) {
    return false;
  }
  shading_.update(work.scene, work.plan, work.transfers);
  clock.finish(Stage::prepare);
  return true;
}

// False if stopped.
bool FrameStages::make_transfers(FrameContext& work) {
  if (!work.own_transfers || work.transfers.has(work.plan.transfers)) return true;
  const Job job = std::exchange(work.job, work.job.subrange(0.5, 1.0));
  return work.own_transfers->make(work.plan.transfers, {}, job.subrange(0.0, 0.5));
}

std::vector<SeenPane> FrameStages::seen_panes(const FrameContext& work) const {
  std::vector<SeenPane> panes(work.frame.depth.size());
  work.job.parallel_for(panes.size(), [&](std::size_t pixel) {
    const SurfaceHit seen = hit(pixel);
    // Not averaged over the pixel: find_hits_behind_panes() goes on where this lets light through.
    if (seen) panes[pixel] = prepared_.ray_caster().pane(seen, 0.0);
  });
  return panes;
}

void FrameStages::find_hits_behind_panes(FrameContext& work) {
  const RayCaster& ray_caster = prepared_.ray_caster();
  const auto width = static_cast<std::size_t>(work.frame.film.width);
  work.frame.depth.resize(hits_.size());
  work.job.parallel_for(hits_.size() / width, [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t pixel = y * width + x;
      const SurfaceHit before = hit(pixel);
      if (before && ray_caster.pane(before, 0.0).passing > 0.0) {
        const glm::dvec2 place(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
        const glm::dvec3 origin = work.rays.origin(place.x, place.y);
        const glm::dvec3 direction = work.rays.direction(place.x, place.y);
        SurfaceHit next = ray_caster.next_hit(origin, direction, before);
        work.light_shapes.meet(origin, direction, next);
        set_hit(pixel, next);
      }
      work.frame.depth[pixel] = hits_[pixel].distance;
    }
  });
}

SurfaceHit FrameStages::hit(std::size_t pixel) const {
  if (hits_.empty()) return {};
  SurfaceHit hit =
      prepared_.ray_caster().hit_of(hits_[pixel], copies_.empty() ? 0 : copies_[pixel]);
  if (!distances_.empty()) hit.distance = distances_[pixel];
  return hit;
}

void FrameStages::set_hit(std::size_t pixel, const SurfaceHit& hit) {
  hits_[pixel] = prepared_.ray_caster().pixel_of(hit);
  if (!distances_.empty()) distances_[pixel] = hit.distance;
  if (!copies_.empty()) copies_[pixel] = hit.copy;
}

bool FrameStages::prepare_source(FrameContext& work, StageClock& clock) {
  const bool has_environment = work.plan.runs(Stage::environment);
  const bool has_multiple = work.plan.runs(Stage::scattering);
  if (has_multiple) {
    emission_lights_.update(prepared_.medium(), work.group.albedo,
                            has_surfaces() ? &prepared_.ray_caster() : nullptr, work.job);
  }
  if (!work.plan.has_environment_in_medium && !has_multiple) source_.clear();
  if (!work.plan.has_source_function()) return true;
  SourceFunction::Input input{has_environment ? &*work.scene.environment : nullptr,
                              prepared_.gaussians(),
                              work.scene.optics.anisotropy,
                              has_environment ? fog_depth(work) : 0.0,
                              has_multiple ? work.fog_extent.ball() : work.fog_extent.fog(),
                              lit_space(work),
                              {},
                              work.settings.source_grid,
                              {},
                              work.scene.medium.revision(),
                              work.plan.motion};
  if (work.plan.has_receivers)
    input.receivers = {prepared_.ray_caster().bounds(), incident_optics(work)};
  if (has_multiple) {
    input.multiple = multiple_scattering(work, clock);
    input.view_fog_depth = view_fog_depth(work);
  }
  const auto grid_is_made = [&] {
    clock.finish(has_environment ? Stage::environment : Stage::scattering);
  };
  if (!source_.update(input, work.job, grid_is_made)) return false;
  work.frame.statistics.grid_bytes = source_.bytes();
  if (has_multiple) {
    work.frame.statistics.scattering = source_.convergence();
    clock.finish(Stage::scattering);
  }
  return true;
}

SourceFunction::Multiple FrameStages::multiple_scattering(FrameContext& work, StageClock& clock) {
  SourceFunction::Multiple multiple{
      {},
      &emission_lights_,
      work.group.albedo,
      has_surfaces() ? &prepared_.ray_caster() : nullptr,
      work.scene.surfaces,
      work.settings.scattering_limits,
      has_surfaces() && is_indoors(prepared_.ray_caster(), work.rays.eye()),
      &work.rays};
  for (PointSource& source : work.sources()) {
    const OpticalDepthTable* const table =
        work.plan.runs(Stage::light_table) ? &table_of(work, source.position) : nullptr;
    multiple.lights.push_back({std::move(source), table});
  }
  if (work.plan.runs(Stage::light_table)) clock.finish(Stage::light_table);
  return multiple;
}

namespace {

// The part of a box that holds a ball of fog; the box if there is none.
Box within(const Box& box, const FogBall& fog) {
  if (fog.is_endless()) return box;
  const Box part{glm::max(box.low, fog.center - fog.radius),
                 glm::min(box.high, fog.center + fog.radius)};
  return glm::any(glm::greaterThanEqual(part.low, part.high)) ? box : part;
}

}  // namespace

LitSpace FrameStages::lit_space(const FrameContext& work) const {
  const bool has_fog = work.plan.runs(Stage::homogeneous);
  const double b0 = prepared_.medium().homogeneous_density();
  const FogBall& ball = work.fog_extent.ball();
  const auto is_there = [](const GaussianTerm<double>& g) { return g.c > 0.0; };
  const bool has_gaussians = std::ranges::any_of(prepared_.medium().gaussians(), is_there);
  if (has_surfaces()) {
    const RayCaster& surfaces = prepared_.ray_caster();
    if (!has_fog && has_gaussians) return {{}, surfaces.bounds()};
    const bool is_lit_from_afar = work.fog_extent.has_far_light();
    // Then light is everywhere, and finest nodes are around Gaussians: a forest in mist was 8% too
    // bright else. A room is dark, and nodes as far apart as it is high see through its walls.
    if (is_lit_from_afar && has_gaussians) {
      const std::optional<Box> room = closed_room_around(surfaces, work.rays.eye());
      return room ? LitSpace{within(*room, work.fog_extent.fog())} : LitSpace();
    }
    std::vector<glm::dvec3> lights;
    for (const PointLight& light : work.plan.lights) {
      if (!light.is_far) lights.push_back(light.position);
    }
    if (work.plan.runs(Stage::scattering)) {
      for (const EmissionLights::Light& light : emission_lights_.lights())
        lights.push_back(light.source.position);
    }
    LitSpace lit = space_lit_near(surfaces, lights, room_around(surfaces, work.rays.eye()),
                                  has_fog ? scattering_reach(b0, ball) : 0.0);
    lit.fog = within(lit.fog, work.fog_extent.fog());
    if (is_lit_from_afar) {
      lit.open = LitSpace().open;
    } else if (close_in(surfaces, lights)) {
      lit.open = surfaces.bounds();
      lit.is_closed = true;
    }
    return lit;
  }
  // Nodes are around Gaussians; in endless fog, where none of these shines, also around lights.
  const bool is_lit_nearby =
      std::ranges::any_of(work.plan.lights, [](const PointLight& light) { return !light.is_far; });
  const bool has_emission = work.plan.runs(Stage::scattering) && !emission_lights_.lights().empty();
  if (!has_fog) return {};
  if (has_gaussians && (!ball.is_endless() || !is_lit_nearby || has_emission)) return {};
  // Light from far away is scattered wherever there is fog.
  if (work.fog_extent.has_far_light())
    return {{ball.center - ball.radius, ball.center + ball.radius}};
  return {within(fog_bounds(b0, work.plan.lights, work.rays.eye()), ball)};
}

IncidentOptics FrameStages::incident_optics(const FrameContext& work) const {
  IncidentOptics optics;
  // In a ball it is part of what the nodes hold.
  if (work.fog_extent.fog().is_endless()) {
    optics.fog_density = prepared_.medium().homogeneous_density();
  }
  optics.anisotropy = work.scene.optics.anisotropy;
  const double fog = fog_depth(work);
  const ScatterTable::Bands fractions =
      shading_.environment()->incident(static_cast<float>(fog), work.group.albedo);
  std::copy_n(fractions.begin(), grid_bands, optics.through_fog.begin());
  optics.scattered = work.group.albedo * std::exp(-fog);
  return optics;
}

namespace {

// Length of fog on the way from a point by q.
double fog_length(const FogBall& fog, const glm::dvec3& point, const glm::dvec3& q) {
  const double distance = glm::length(q);
  return distance > 0.0 ? fog.length(point, q / distance, distance) : 0.0;
}

// From a point to where the ray through it starts; 0 where none reaches it.
glm::dvec3 to_eye(const CameraRays& rays, const glm::dvec3& point) {
  if (!rays.is_parallel()) return rays.eye() - point;
  return -std::max(rays.distance_to(point), 0.0) * rays.forward();
}

}  // namespace

PaperLights FrameStages::paper_lights(FrameContext& work, StageClock& clock) {
  const MediumIndex& medium = prepared_.medium();
  const Settings::Precision precision = work.plan.precision;
  const glm::dvec3& eye = work.rays.eye();
  PaperLights paper;
  paper.at_mean = work.settings.paper.at_mean;
  for (const PointLight& light : work.plan.lights) {
    PaperLight& l = paper.lights.emplace_back();
    l.position = light.position;
    l.intensity = light.intensity;
    l.h_min = min_light_distance(work.rays, work.camera, light.position);
  }
  if (work.plan.runs(Stage::light_depth)) {
    const bool conserve_energy =
        work.settings.paper.conserve_energy && !starts_in_dense_gaussian(medium, work.rays);
    for (PaperLight& light : paper.lights) {
      light.conserve_energy = conserve_energy && !is_in_dense_gaussian(medium, light.position);
      const CenterDepths& from_light =
          prepared_.light_depths(light.position, precision, work.frame.statistics.light_pairs);
      light.frozen = from_light.depths;
      const glm::dvec3 q = to_eye(work.rays, light.position);
      const double distance = glm::length(q);
      if (work.plan.runs(Stage::homogeneous) && distance > 0.0) {
        const RaySegment to_light{light.position, q / distance, distance};
        light.depth_to_eye =
            medium.depth(to_light) - medium.fog_depth(light.position, q / distance, distance);
      }
    }
    clock.finish(Stage::light_depth);

    CenterDepths from_eye = work.rays.is_parallel()
                                ? parallel_center_depths(medium, eye, work.rays.forward())
                                : center_depths(medium, eye, precision);
    work.frame.statistics.view_pairs += from_eye.pairs;
    paper.from_eye = std::move(from_eye.depths);
    const double b0 = medium.homogeneous_density();
    for (std::size_t i = 0; i < medium.size(); ++i) {
      const glm::dvec3& b = medium.gaussians()[i].b;
      const double to_view = medium.fog().is_endless()
                                 ? std::max(work.rays.distance_to(b), 0.0)
                                 : fog_length(medium.fog(), b, to_eye(work.rays, b));
      for (PaperLight& light : paper.lights) {
        light.frozen[i] +=
            paper.from_eye[i] + b0 * (fog_length(medium.fog(), b, light.position - b) + to_view);
      }
    }
    clock.finish(Stage::eye_depth);
  }
  return paper;
}

const OpticalDepthTable& FrameStages::table_of(FrameContext& work, const glm::dvec3& light) {
  return prepared_.optical_depth_table(light, work.settings.optical_depth_table,
                                       work.frame.statistics.light_pairs);
}

std::vector<SlicedLight> FrameStages::lights_of(const FrameContext& work) {
  std::vector<SlicedLight> lights;
  for (PointSource& source : work.sources()) {
    lights.push_back({std::move(source), nullptr, nullptr});
  }
  return lights;
}

std::vector<SlicedLight> FrameStages::lit_from(const FrameContext& work,
                                               std::vector<SlicedLight> lights) const {
  if (!work.plan.runs(Stage::scattering) || !work.plan.runs(Stage::homogeneous)) return lights;
  for (const EmissionLights::Light& light : emission_lights_.lights()) {
    lights.push_back({light.source, nullptr, nullptr});
  }
  return lights;
}

std::vector<SlicedLight> FrameStages::sliced_lights(FrameContext& work, StageClock& clock) {
  std::vector<SlicedLight> lights = lights_of(work);
  std::vector<DirectionMap> maps(lights.size());
  if (work.plan.runs(Stage::light_table)) {
    for (std::size_t l = 0; l < lights.size(); ++l) {
      lights[l].table = &table_of(work, lights[l].position);
      maps[l] = lights[l].table->map();
    }
    clock.finish(Stage::light_table);
  }
  if (work.plan.runs(Stage::shadow_map)) {
    for (std::size_t l = 0; l < lights.size(); ++l) {
      lights[l].shadows =
          &prepared_.shadow_map(lights[l].position, shadow_directions(work, lights[l], maps[l]));
    }
    clock.finish(Stage::shadow_map);
  }
  return lights;
}

// Cells as wide as the walls of a small room in a large scene would let light through these.
int FrameStages::far_shadow_cells(const FrameContext& work) const {
  const int cells = work.settings.shadow_cells;
  if (!room_around(prepared_.ray_caster(), work.rays.eye())) return cells;
  const auto far = std::ranges::count_if(work.plan.lights, &PointLight::is_far);
  const double for_all = 2.0 * max_shadow_cells / std::sqrt(static_cast<double>(far));
  return std::max(cells, std::min({max_shadow_cells, 8 * cells / 3, static_cast<int>(for_all)}));
}

// Fog scatters in every direction, Gaussians only where they are.
DirectionMap FrameStages::shadow_directions(const FrameContext& work, const PointSource& light,
                                            const DirectionMap& table) const {
  const int cells = work.settings.shadow_cells;
  if (!work.plan.runs(Stage::homogeneous)) return table.resized(cells);
  if (!light.is_far) return DirectionMap::full_sphere(cells);
  // Only surfaces keep light of far lights from fog; beside them nothing does.
  const Box& bounds = prepared_.ray_caster().bounds();
  const Ball surfaces{0.5 * (bounds.low + bounds.high),
                      0.5 * glm::length(bounds.high - bounds.low)};
  return DirectionMap::towards(light.position, std::span(&surfaces, 1), far_shadow_cells(work));
}

SurfaceLighting FrameStages::surface_lighting(const FrameContext& work) const {
  SurfaceLighting lighting;
  lighting.environment = shading_.environment();
  lighting.albedo = work.group.albedo;
  if (lighting.environment) {
    lighting.fog_depth = fog_depth(work);
    lighting.fog = work.fog_extent.fog();
    lighting.fog_density = prepared_.medium().homogeneous_density();
    if (work.plan.has_receivers) {
      lighting.incident = &source_.grid();
      lighting.incident_scale = work.scene.environment->intensity;
    }
  }
  if (work.plan.has_all_light_at_surfaces) {
    lighting.incident = &source_.grid();
    lighting.incident_is_all = true;
    lighting.extinction = source_.light_extinction();
    lighting.visibility = NodeVisibility(source_.grid(), work.rays.eye());
  } else if (work.plan.runs(Stage::surface_scattering)) {
    const bool paper = work.settings.paper_spread;
    lighting.point = paper ? &ScatterTable::paper() : &ScatterTable::point();
    lighting.distant = paper ? &ScatterTable::paper() : &ScatterTable::distant();
  }
  for (PointSource& source : work.sources()) {
    const double density = !source.is_far ? prepared_.medium().density(source.position) : 0.0;
    lighting.lights.push_back({std::move(source), density});
  }
  return lighting;
}

SurfaceLighting FrameStages::tabled_lighting(FrameContext& work) {
  SurfaceLighting lighting = surface_lighting(work);
  if (work.plan.surface_depths == RenderPlan::SurfaceDepths::tables) {
    for (SurfaceLight& light : lighting.lights) {
      light.table = &table_of(work, light.source.position);
    }
  }
  return lighting;
}

void FrameStages::update_vertex_lighting(FrameContext& work) {
  if (!work.plan.runs(Stage::vertex_light)) return;
  shading_.update_vertex_lighting(work.scene, prepared_.medium(), tabled_lighting(work), work.plan,
                                  work.job, work.frame.statistics.light_pairs);
}

const SharedHighlights& FrameStages::find_highlights_behind(FrameContext& work,
                                                            std::span<const RasterPixel> hits,
                                                            std::span<const std::uint32_t> copies) {
  std::vector<glm::vec3> radiance(hits.size());
  if (work.plan.has_mirrors) {
    work.frame.statistics.light_pairs +=
        film_surfaces(work).shade(hits, copies, work.job, radiance, highlights_behind_);
  } else {
    highlights_behind_.reset(glm::ivec2(0), 0.0f);
  }
  return highlights_behind_;
}

std::span<const glm::vec3> FrameStages::shade_surfaces(FrameContext& work, StageClock& clock) {
  if (!work.plan.runs(Stage::surfaces)) return {};
  surface_radiance_.resize(hits_.size());
  update_vertex_lighting(work);
  lighting_ = tabled_lighting(work);
  work.frame.statistics.light_pairs +=
      film_surfaces(work).shade(hits_, copies_, work.job, surface_radiance_, highlights_);
  clock.finish(Stage::surfaces);
  return surface_radiance_;
}

}  // namespace brume
