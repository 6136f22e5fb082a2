#include "render/renderer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "core/scene/materials/coverage.h"
#include "render/cpu/composite.h"
#include "render/cpu/film_airlight.h"
#include "render/cpu/film_samples.h"
#include "render/cpu/film_slices.h"
#include "render/cpu/pane_layers.h"
#include "render/cpu/paper_airlight.h"
#include "render/cpu/sliced_airlight.h"
#include "render/cpu/traced_paths.h"
#include "render/prepare/frame_stages.h"
#include "render/prepare/sample_spacing.h"
#include "render/reference/reference_airlight.h"
#include "render/samples/brightness.h"
#include "render/samples/mean_frame.h"
#include "render/scattering/source_view.h"
#include "render/visibility/holdout.h"

namespace brume {

struct Renderer::Impl {
  FrameStages stages;
  FilmSlices film_slices;
  SourceView source_view;
  std::vector<TracedPaths> paths{1};  // by layer of panes

  std::optional<Frame> render(FrameContext& work);
  // The picture of the layers, and of the radiance of surfaces, RGB per pixel.
  void composite(FrameContext& work, std::span<const glm::vec3> surfaces);
  // Outgoing radiance of surfaces, RGB per pixel; empty if none is lit.
  // `passing`: see PathFilm::View.
  std::span<const glm::vec3> trace_paths(FrameContext& work, std::size_t layer,
                                         std::function<float(std::size_t)> passing,
                                         StageClock& clock);
  // Adds what paths see through panes to the frame, which holds what is in front of the first ones.
  void trace_through_panes(FrameContext& work, StageClock& clock);
  // The medium on the view rays, for more of them.
  struct SeenMedium {
    AirlightIntegrator method;
    Tiles::Lists lists;
    std::optional<PaneView> panes;                        // nullopt: none are seen
    const SharedHighlights* highlights_behind = nullptr;  // with panes
  };
  SeenMedium integrate_medium(FrameContext& work, StageClock& clock);
  // The fog as far as these ends, at the pixels of a window.
  FilmAirlight integrate_fog(FrameContext& work, const FilmWindow& window,
                             const AirlightIntegrator& method, const RayEnds& ends);
  void see_through_panes(FrameContext& work, SeenMedium& medium, StageClock& clock);
  void sample_pixels(FrameContext& work, const SeenMedium& medium, StageClock& clock);
  // Calls sample(view) with the view of samples of a frame whose fog is known.
  void with_samples(FrameContext& work, const SeenMedium& medium,
                    const std::function<std::uint64_t(SampledView& view)>& sample);
  AirlightIntegrator airlight_method(FrameContext& work, StageClock& clock);
  AirlightIntegrator paper(FrameContext& work, StageClock& clock);
  AirlightIntegrator sliced(FrameContext& work, StageClock& clock);
  AirlightIntegrator reference(FrameContext& work) const;
};

Renderer::Renderer() : own_transfers_(std::make_shared<TransferStore>()) {
  transfers_ = own_transfers_;
}
Renderer::Renderer(std::shared_ptr<const TransferStore> transfers)
    : transfers_(std::move(transfers)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

std::optional<Frame> Renderer::render(const Scene& scene, const Camera& camera, const Film& film,
                                      const Settings& settings, std::stop_token stop,
                                      const std::function<void(double)>& progress,
                                      const Motion& motion) {
  const auto render_film = [&](const Film& shifted, const Settings& wanted, const Job& job) {
    const RenderPlan plan(scene, shifted, with_useful_spacing(scene, camera, shifted, wanted),
                          own_transfers_ ? nullptr : transfers_.get(), motion);
    return render(plan, scene, camera, shifted, job);
  };
  const Job job{std::move(stop), progress};
  return settings.airlight == AirlightMethod::path && settings.samples > 1
             ? render_shifted(film, settings, job, render_film)
             : render_film(film, settings, job);
}

std::optional<Frame> Renderer::render(const RenderPlan& plan, const Scene& scene,
                                      const Camera& camera, const Film& film, const Job& job) {
  tbb::task_arena arena(plan.settings.threads > 0 ? plan.settings.threads
                                                  : tbb::task_arena::automatic);
  const FogExtent fog_extent(scene);
  const FilmWindow window(film, plan.settings);
  const auto render_one = [&](const Scene& group_scene, std::size_t which, const AlbedoGroup& group,
                              const Job& group_job) -> std::optional<Frame> {
    FrameContext work(plan, group_scene, camera, window, *transfers_, own_transfers_.get(),
                      group_job, group, fog_extent);
    std::optional<Frame> frame = arena.execute([&] { return impls_[which]->render(work); });
    if (!frame) return std::nullopt;
    return window.cut(std::move(*frame));
  };

  const std::vector<AlbedoGroup> groups = albedo_groups(scene, plan.has_own_optics);
  while (impls_.size() < groups.size()) impls_.push_back(std::make_unique<Impl>());
  impls_.resize(groups.size());
  return render_groups(scene, groups, media_, job, render_one);
}

std::optional<Frame> Renderer::Impl::render(FrameContext& work) {
  const auto start = std::chrono::steady_clock::now();
  StageClock clock(work.frame.statistics.stages);
  work.make_layers();
  if (!stages.begin(work, clock)) return std::nullopt;
  stages.find_hits(work, clock);
  std::span<const glm::vec3> surfaces;
  SeenMedium medium;
  const Job job = work.job;
  if (work.plan.runs(Stage::samples)) work.job = job.subrange(0.0, 0.5);
  if (work.settings.airlight == AirlightMethod::path) {
    surfaces = trace_paths(work, 0, {}, clock);
  } else {
    if (!stages.prepare_source(work, clock)) return std::nullopt;
    medium = integrate_medium(work, clock);
    work.set_mirrored_ways(medium.method.along);
    surfaces = stages.shade_surfaces(work, clock);
  }
  if (work.job.stop.stop_requested()) return std::nullopt;
  composite(work, surfaces);
  if (work.settings.background_apart) set_background_apart(work.frame);
  clock.finish(Stage::composite);
  if (work.plan.has_panes) {
    if (work.settings.airlight == AirlightMethod::path) {
      trace_through_panes(work, clock);
    } else {
      see_through_panes(work, medium, clock);
    }
  }
  if (work.job.stop.stop_requested()) return std::nullopt;
  if (work.plan.runs(Stage::samples)) {
    work.job = job.subrange(0.5, 1.0);
    sample_pixels(work, medium, clock);
    if (work.job.stop.stop_requested()) return std::nullopt;
  }
  work.frame.statistics.frame_milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return std::move(work.frame);
}

void Renderer::Impl::composite(FrameContext& work, std::span<const glm::vec3> surfaces) {
  brume::composite(work.rays, stages.background(work), surfaces, work.job, work.frame);
  if (!work.plan.runs(Stage::visibility) || !has_holdouts(work.scene.surfaces)) return;
  const auto is_hit_held_out = [&](std::size_t pixel) {
    return is_held_out(work.scene.surfaces, stages.hit(pixel));
  };
  hold_out(is_hit_held_out, work.job, work.frame);
}

void Renderer::Impl::trace_through_panes(FrameContext& work, StageClock& clock) {
  PaneLayers layers(work.frame);
  layers.add(stages.seen_panes(work), work.frame);
  for (std::size_t layer = 1; layers.are_open() && layer <= max_seen_panes; ++layer) {
    stages.find_hits_behind_panes(work);
    const auto passing = [&layers](std::size_t pixel) { return layers.passing(pixel); };
    const std::span<const glm::vec3> surfaces = trace_paths(work, layer, passing, clock);
    if (work.job.stop.stop_requested()) return;
    composite(work, surfaces);
    layers.add(stages.seen_panes(work), work.frame);
  }
  layers.write(work.frame);
}

std::span<const glm::vec3> Renderer::Impl::trace_paths(FrameContext& work, std::size_t layer,
                                                       std::function<float(std::size_t)> passing,
                                                       StageClock& clock) {
  if (layer >= paths.size()) paths.resize(layer + 1);
  const std::span<const glm::vec3> surfaces = paths[layer].trace(stages, work, std::move(passing));
  if (work.plan.runs(work.plan.medium_stage())) clock.finish(work.plan.medium_stage());
  return surfaces;
}

// Airlight and transmittance of the view rays.
Renderer::Impl::SeenMedium Renderer::Impl::integrate_medium(FrameContext& work, StageClock& clock) {
  if (!work.plan.has_medium()) return {};
  AirlightIntegrator method = airlight_method(work, clock);
  FilmAirlight film = integrate_fog(work, work.window, method, stages.ray_ends(work));
  FrameStatistics& statistics = work.frame.statistics;
  statistics.gaussians_used = film.gaussians_used;
  statistics.exact_pixels = film.exact_pixels;
  if (stages.prepared().is_merged()) {
    statistics.gaussians_merged = stages.prepared().medium().size();
  }
  clock.finish(work.plan.medium_stage());
  return {std::move(method), std::move(film.lists), std::nullopt, nullptr};
}

FilmAirlight Renderer::Impl::integrate_fog(FrameContext& work, const FilmWindow& window,
                                           const AirlightIntegrator& method, const RayEnds& ends) {
  FilmAirlight film =
      film_airlight(stages.prepared().medium(), work.plan.lights, work.rays, window, work.settings,
                    work.airlight_rms(), method, ends, work.job, work.frame);
  work.frame.statistics.view_pairs += film.pairs;
  return film;
}

void Renderer::Impl::with_samples(FrameContext& work, const SeenMedium& medium,
                                  const std::function<std::uint64_t(SampledView& view)>& sample) {
  const int scale = work.settings.airlight_scale;
  const Tiles tiles(sample_film(work.frame.film, scale));
  const RayEnds ends = medium.panes ? medium.panes->ends() : stages.ray_ends(work);
  std::vector<KnownFog> fogs{
      {work.frame.airlight, work.frame.transmittance, work.frame.depth, ends}};
  if (medium.panes) {
    const auto seen = medium.panes->fogs();
    fogs.assign(seen.begin(), seen.end());
  }
  // Samples see what pixels beside their tile see, perhaps farther away.
  const FilmTiles film{tiles, medium.lists, work.rays, ends, work.frame, work.window, scale, 1};
  const FilmSurfaces surfaces = stages.film_surfaces(work);
  SampledView view{.tiles = film,
                   .fogs = fogs,
                   .surfaces = work.plan.runs(Stage::visibility) ? &surfaces : nullptr,
                   .highlights = {&stages.highlights(), medium.highlights_behind},
                   .are_lit = work.plan.runs(Stage::surfaces),
                   .environment = stages.background(work),
                   .fog_tolerance = work.settings.upsampling_tolerance};
  if (work.plan.has_medium()) {
    view.medium = &stages.prepared().medium();
    view.method = &medium.method;
    if (view.method->prepare) view.method->prepare(film);
  }
  work.frame.statistics.view_pairs += sample(view);
}

void Renderer::Impl::see_through_panes(FrameContext& work, SeenMedium& medium, StageClock& clock) {
  PaneView panes(stages, work);
  if (panes.empty()) return;
  if (work.plan.has_medium()) {
    panes.find_fog(work.frame, [&] {
      integrate_fog(work, work.window.around(panes.around()), medium.method, panes.ends());
    });
    clock.finish(work.plan.medium_stage());
  }
  if (work.job.stop.stop_requested()) return;
  if (work.plan.runs(Stage::surfaces)) {
    medium.highlights_behind = &stages.find_highlights_behind(work, panes.hits(), panes.copies());
  }
  medium.panes = std::move(panes);
  with_samples(work, medium, [&](const SampledView& view) {
    return brume::see_through_panes(view, medium.panes->pixels(), work.window.complete(), work.job,
                                    work.frame);
  });
  clock.finish(Stage::surfaces);
}

void Renderer::Impl::sample_pixels(FrameContext& work, const SeenMedium& medium,
                                   StageClock& clock) {
  const Brightness brightness = work.settings.brightness
                                    ? *work.settings.brightness
                                    : brightness_of(work.frame, work.window.region());
  with_samples(work, medium, [&](SampledView& view) {
    view.picture_rms = brightness.rms;
    return sample_film(view, find_details(work.frame, brightness.mean, work.job),
                       work.settings.samples, work.job, work.frame);
  });
  clock.finish(Stage::samples);
}

AirlightIntegrator Renderer::Impl::airlight_method(FrameContext& work, StageClock& clock) {
  switch (work.settings.airlight) {
    case AirlightMethod::paper:
      return paper(work, clock);
    case AirlightMethod::auto_:
    case AirlightMethod::sliced:
      return sliced(work, clock);
    case AirlightMethod::reference:
      return reference(work);
    case AirlightMethod::path:  // trace_paths()
      break;
  }
  return {};
}

AirlightIntegrator Renderer::Impl::paper(FrameContext& work, StageClock& clock) {
  return {[this, &work, lights = stages.paper_lights(work, clock)](
              auto gaussians, const TileRays& rays, const TileAirlight& out) {
            const std::uint64_t pairs = paper_airlight(stages.prepared().medium(), gaussians,
                                                       lights, rays, work.plan.precision, out);
            if (const EnvironmentLight* environment = stages.shading().environment()) {
              for (std::size_t k = 0; k < rays.directions.size(); ++k) {
                out.airlight[k] += environment->environment_inscattering(
                    rays.directions[k], static_cast<float>(out.depths[k]));
              }
            }
            return pairs;
          },
          {}};
}

AirlightIntegrator Renderer::Impl::sliced(FrameContext& work, StageClock& clock) {
  const auto lights =
      std::make_shared<const std::vector<SlicedLight>>(stages.sliced_lights(work, clock));
  std::optional<SlicedSource> source;
  if (const SourceFunction* function = stages.source_function(work)) {
    source_view.update(*function, work.rays, work.job);
    source = {function, source_view.lookup(*function), &function->eye_lobe()};
  }
  const auto evaluate = [this, lights, source](auto gaussians, const TileRays& rays,
                                               const TileAirlight& out) {
    return sliced_airlight(stages.prepared().medium(), gaussians, *lights,
                           source ? &*source : nullptr, rays, film_slices.nodes(rays.tile), out);
  };
  const auto prepare = [this, &work, lights](const FilmTiles& film) {
    film_slices.choose(film, stages.prepared().medium(), stages.lit_from(work, *lights),
                       work.settings.slices, work.job);
  };
  return {
      evaluate, prepare,
      sliced_airlight_along(stages.prepared().medium(), lights, source ? source->function : nullptr,
                            work.settings.slices, work.group.albedo)};
}

AirlightIntegrator Renderer::Impl::reference(FrameContext& work) const {
  std::vector<PointSource> lights = work.sources();
  std::optional<ReferenceEnvironment> environment;
  if (work.plan.has_environment) {
    environment.emplace(*work.scene.environment, work.scene.optics.anisotropy,
                        stages.fog_depth(work), work.settings.reference_tolerance);
  }
  return {[this, &work, lights = std::move(lights), environment = std::move(environment)](
              auto, const TileRays& rays, const TileAirlight& out) {
            std::uint64_t view_pairs = 0;
            std::uint64_t light_pairs = 0;
            // For the rays that are left out when the job is stopped.
            std::ranges::fill(out.airlight, glm::vec3(0.0f));
            std::ranges::fill(out.depths, 0.0f);
            for (std::size_t k = 0; k < rays.directions.size(); ++k) {
              if (work.job.stop.stop_requested()) break;
              const ReferenceRay ray = reference_airlight(
                  stages.prepared().medium(), stages.prepared().exact_occlusion(), lights,
                  environment ? &*environment : nullptr, rays.origin(k), rays.directions[k],
                  rays.lengths[k], work.settings.reference_tolerance);
              out.airlight[k] = glm::vec3(ray.airlight);
              out.depths[k] = ray.depth;
              view_pairs += ray.view_pairs;
              light_pairs += ray.light_pairs;
            }
            std::atomic_ref(work.frame.statistics.light_pairs) += light_pairs;
            return view_pairs;
          },
          {}};
}

}  // namespace brume
