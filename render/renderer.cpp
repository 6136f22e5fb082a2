#include "render/renderer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "render/albedo.h"
#include "render/cpu/marched_airlight.h"
#include "render/cpu/paper_airlight.h"
#include "render/cpu/path_depths.h"
#include "render/cpu/sliced_airlight.h"
#include "render/cpu/surfaces.h"
#include "render/cpu/visibility.h"
#include "render/environment_source.h"
#include "render/film_airlight.h"
#include "render/film_surfaces.h"
#include "render/fog_end.h"
#include "render/job.h"
#include "render/light_limits.h"
#include "render/medium_index.h"
#include "render/prepared_scene.h"
#include "render/prepared_shading.h"
#include "render/reference/reference_airlight.h"
#include "render/render_plan.h"
#include "render/tiles.h"
#include "render/transfer/transfer_store.h"

namespace brume {
namespace {

class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& stages) : stages_(stages) {}
  void finish(const char* name) {
    const auto now = std::chrono::steady_clock::now();
    stages_.push_back({name, std::chrono::duration<double, std::milli>(now - last_).count()});
    last_ = now;
  }

 private:
  std::vector<StageTime>& stages_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

struct Renderer::Impl {
  PreparedScene prepared;
  PreparedShading shading;
  EnvironmentSource source;
  // Kept from frame to frame for their memory only.
  std::vector<SurfaceHit> hits;
  std::vector<glm::vec3> surface_radiance;

  // One frame's state, stage by stage.
  struct Work {
    const Scene& scene;
    const Camera& camera;
    const Settings& settings;
    const TransferStore& transfers;
    TransferStore* own_transfers;  // to make what is missing in; null: nothing is made
    Job job;
    double albedo;  // of the channels that count
    FogEnd fog_end;
    RenderPlan plan;
    CameraRays rays;
    Tiles tiles;
    Frame frame;
  };

  std::optional<Frame> render(Work& work);
  static bool find_transfers(Work& work);
  void find_surfaces(Work& work, double ray_end);
  bool prepare_source(const Work& work, StageClock& clock);
  ArrivalOptics arrival_optics(const Work& work) const;
  TileMethod airlight_method(Work& work, StageClock& clock);
  TileMethod paper(Work& work, StageClock& clock);
  TileMethod sliced(Work& work, StageClock& clock);
  TileMethod march(const Work& work) const;
  TileMethod reference(Work& work) const;
  // Null: there is none to scatter.
  const EnvironmentSource* scattered_environment(const Work& work) const {
    return work.plan.environment ? &source : nullptr;
  }
  // Of b0, from any point to where the fog ends.
  double fog_depth(const Work& work) const {
    return work.fog_end.depth_of_surfaces(prepared.medium().homogeneous_density());
  }
  void shade_surfaces(Work& work);
  void composite(Work& work) const;

  // Calls visit(pixel index, x, y) for the pixels of a tile.
  template <class Visit>
  static void each_pixel(const Work& work, std::size_t tile, Visit visit) {
    const auto width = static_cast<std::size_t>(work.frame.film.width);
    Tiles::each_pixel(work.tiles.rectangle(tile), [&](int x, int y) {
      visit(static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x), x, y);
    });
  }
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
                                      const std::function<void(double)>& progress) {
  const Job job{std::move(stop), progress};
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  const FogEnd fog_end(scene);
  const auto render_one = [&](const Scene& of, std::size_t which, double albedo, const Job& part) {
    Impl::Work work{of,
                    camera,
                    settings,
                    *transfers_,
                    own_transfers_.get(),
                    part,
                    albedo,
                    fog_end,
                    RenderPlan(of, settings.airlight),
                    CameraRays(camera, film),
                    Tiles(film),
                    {}};
    work.frame.film = film;
    work.frame.time = settings.time;
    return arena.execute([&] { return impls_[which]->render(work); });
  };

  const std::vector<AlbedoGroup> groups = albedo_groups(scene.optics.albedo);
  while (impls_.size() < groups.size()) impls_.push_back(std::make_unique<Impl>());
  impls_.resize(groups.size());
  if (groups.size() == 1 && groups[0].albedo == 1.0) return render_one(scene, 0, 1.0, job);

  std::optional<Frame> frame;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Scene absorbing = scene;
    absorbing.medium = extinction_medium(scene.medium, groups[i].albedo);
    const auto share = [&](std::size_t n) {
      return static_cast<double>(n) / static_cast<double>(groups.size());
    };
    std::optional<Frame> part =
        render_one(absorbing, i, groups[i].albedo, job.part(share(i), share(i + 1)));
    if (!part) return std::nullopt;
    if (!frame) {
      frame = *part;
    } else {
      add_cost(part->statistics, frame->statistics);
    }
    take_channels(groups[i], *part, *frame);
  }
  for (std::size_t i = 0; i < frame->depth.size(); ++i) {
    if (std::isfinite(frame->depth[i])) continue;  // a surface covers its pixel
    const float* transmittance = frame->transmittance.data() + 3 * i;
    frame->beauty[4 * i + 3] =
        1.0f - (transmittance[0] + transmittance[1] + transmittance[2]) / 3.0f;
  }
  return frame;
}

std::optional<Frame> Renderer::Impl::render(Work& work) {
  const auto start = std::chrono::steady_clock::now();
  FrameStatistics& statistics = work.frame.statistics;
  statistics.skipped = work.plan.skipped;
  statistics.gaussians_total = work.scene.medium.size();
  StageClock clock(statistics.stages);
  if (!work.plan.transfers.empty()) {
    if (!find_transfers(work)) return std::nullopt;
    clock.finish("transfer");
  }
  const auto pixels = static_cast<std::size_t>(work.frame.film.width) *
                      static_cast<std::size_t>(work.frame.film.height);
  work.frame.beauty.resize(4 * pixels);
  work.frame.airlight.resize(3 * pixels);
  work.frame.transmittance.assign(3 * pixels, 1.0f);
  work.frame.depth.assign(pixels, std::numeric_limits<float>::infinity());
  const double ray_end = work.fog_end.of_rays(work.rays.eye());
  if (work.plan.surfaces) {
    hits.resize(pixels);
  } else {
    hits.assign(std::isfinite(ray_end) ? pixels : 0, {ray_end});
  }
  surface_radiance.resize(work.plan.lit_surfaces ? pixels : 0);

  prepared.update(work.scene, work.plan.lights, work.settings);
  shading.update(work.scene, work.plan, work.settings, work.transfers);
  clock.finish("prepare");
  if (work.plan.surfaces) {
    find_surfaces(work, ray_end);
    clock.finish("visibility");
  }
  if (!prepare_source(work, clock)) return std::nullopt;
  if (work.plan.gaussians || work.plan.homogeneous) {
    const TileMethod method = airlight_method(work, clock);
    const FilmAirlight film = film_airlight(prepared.medium(), work.rays, work.settings, method,
                                            hits, work.job, work.frame);
    statistics.gaussians_used = film.gaussians_used;
    statistics.exact_pixels = film.exact_pixels;
    statistics.view_pairs += film.pairs;
    // Without light there is still what the medium takes away.
    clock.finish(work.plan.airlight ? "airlight" : "transmittance");
  }
  if (work.plan.lit_surfaces) {
    shade_surfaces(work);
    clock.finish("surfaces");
  }
  if (work.job.stop.stop_requested()) return std::nullopt;
  composite(work);
  clock.finish("composite");
  statistics.frame_milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return std::move(work.frame);
}

// False if stopped.
bool Renderer::Impl::find_transfers(Work& work) {
  if (work.transfers.has(work.plan.transfers)) return true;
  if (!work.own_transfers) {
    work.frame.statistics.skipped.push_back({"transfer", "it is not there yet"});
    return true;
  }
  const Job job = std::exchange(work.job, work.job.part(0.5, 1.0));
  return work.own_transfers->make(work.plan.transfers, {}, job.part(0.0, 0.5));
}

// Rays that hit nothing end where the fog does.
void Renderer::Impl::find_surfaces(Work& work, double ray_end) {
  work.job.each(work.tiles.count(), [&](std::size_t tile) {
    std::array<glm::dvec3, Tiles::pixels> directions;
    std::array<SurfaceHit, Tiles::pixels> tile_hits;
    std::size_t count = 0;
    each_pixel(work, tile, [&](std::size_t, int x, int y) {
      directions[count++] = work.rays.direction(x + 0.5, y + 0.5);
    });
    prepared.visibility().first_hits(work.rays.eye(), std::span(directions).first(count),
                                     std::span(tile_hits).first(count));
    count = 0;
    each_pixel(work, tile, [&](std::size_t i, int, int) {
      const SurfaceHit& hit = tile_hits[count++];
      hits[i] = hit ? hit : SurfaceHit{ray_end};
      work.frame.depth[i] = static_cast<float>(hit.distance);
    });
  });
}

// False: the job was stopped.
bool Renderer::Impl::prepare_source(const Work& work, StageClock& clock) {
  const AirlightMethod method = work.settings.airlight;
  const bool airlight =
      work.plan.airlight && (method == AirlightMethod::sliced || method == AirlightMethod::march);
  const bool receivers = work.plan.surfaces && method != AirlightMethod::paper;
  if (!work.plan.environment || !work.plan.airlight) {
    source.clear();
    return true;
  }
  if (!airlight && !receivers) return true;
  EnvironmentSource::Input input{*work.scene.environment,
                                 work.scene.medium,
                                 work.scene.optics.anisotropy,
                                 fog_depth(work),
                                 {},
                                 work.settings.source_grid};
  if (receivers) input.receivers = {prepared.visibility().bounds(), arrival_optics(work)};
  const bool made = source.update(input, work.job);
  clock.finish("environment");
  return made;
}

ArrivalOptics Renderer::Impl::arrival_optics(const Work& work) const {
  ArrivalOptics optics;
  optics.fog_density = prepared.medium().homogeneous_density();
  optics.anisotropy = work.scene.optics.anisotropy;
  const double fog = fog_depth(work);
  const ScatterTable::Bands shares =
      shading.environment()->arriving(static_cast<float>(fog), work.albedo);
  std::copy_n(shares.begin(), grid_bands, optics.through_fog.begin());
  optics.scattered = work.albedo * std::exp(-fog);
  return optics;
}

TileMethod Renderer::Impl::airlight_method(Work& work, StageClock& clock) {
  switch (work.settings.airlight) {
    case AirlightMethod::paper:
      return paper(work, clock);
    case AirlightMethod::sliced:
      return sliced(work, clock);
    case AirlightMethod::march:
      return march(work);
    case AirlightMethod::reference:
      return reference(work);
  }
  return {};
}

TileMethod Renderer::Impl::paper(Work& work, StageClock& clock) {
  const MediumIndex& medium = prepared.medium();
  const Settings::Arithmetic arithmetic = work.settings.arithmetic;
  const glm::dvec3& eye = work.rays.eye();
  PaperLights paper;
  paper.at_mean = work.settings.paper.at_mean;
  for (const PointLight& light : work.plan.lights) {
    PaperLight& l = paper.lights.emplace_back();
    l.position = light.position;
    l.intensity = light.intensity;
    l.h_min = least_light_distance(work.rays, work.camera, light.position);
  }
  if (!paper.lights.empty() && work.plan.gaussians) {
    const bool conserve_energy =
        work.settings.paper.conserve_energy && !is_in_dense_gaussian(medium, eye);
    for (PaperLight& light : paper.lights) {
      light.conserve_energy = conserve_energy && !is_in_dense_gaussian(medium, light.position);
      const CenterDepths& from_light =
          prepared.light_depths(light.position, arithmetic, work.frame.statistics.light_pairs);
      light.frozen = from_light.depths;
      const glm::dvec3 q = eye - light.position;
      const double distance = glm::length(q);
      if (work.plan.homogeneous && distance > 0.0) {
        light.depth_to_eye = medium.depth({light.position, q / distance, distance}) -
                             medium.homogeneous_density() * distance;
      }
    }
    clock.finish("light_depth");

    CenterDepths from_eye = center_depths(medium, eye, arithmetic);
    work.frame.statistics.view_pairs += from_eye.pairs;
    paper.from_eye = std::move(from_eye.depths);
    const double b0 = medium.homogeneous_density();
    for (std::size_t i = 0; i < medium.size(); ++i) {
      const glm::dvec3& b = medium.gaussians()[i].b;
      for (PaperLight& light : paper.lights) {
        light.frozen[i] +=
            paper.from_eye[i] + b0 * (glm::length(b - light.position) + glm::length(b - eye));
      }
    }
    clock.finish("eye_depth");
  }
  return [this, &work, lights = std::move(paper)](auto gaussians, const TileRays& rays,
                                                  const TileAirlight& out) {
    const std::uint64_t pairs =
        paper_airlight(prepared.medium(), gaussians, lights, rays, work.settings.arithmetic, out);
    if (const EnvironmentLight* environment = shading.environment()) {
      for (std::size_t k = 0; k < rays.directions.size(); ++k) {
        out.airlight[k] += environment->glow(rays.directions[k], static_cast<float>(out.depths[k]));
      }
    }
    return pairs;
  };
}

TileMethod Renderer::Impl::sliced(Work& work, StageClock& clock) {
  std::vector<SlicedLight> lights;
  for (const PointLight& light : work.plan.lights) {
    lights.push_back({light.position, light.intensity,
                      least_light_distance(work.rays, work.camera, light.position)});
  }
  if (work.plan.gaussians) {
    for (SlicedLight& light : lights) {
      light.table = &prepared.light_table(light.position, work.settings.light_table,
                                          work.frame.statistics.light_pairs);
    }
    if (!lights.empty()) clock.finish("light_table");
  }
  if (work.plan.surfaces && !lights.empty()) {
    for (SlicedLight& light : lights) {
      // Fog scatters in every direction, Gaussians only where they are.
      const int cells = work.settings.shadow_cells;
      light.shadows = &prepared.shadow_map(light.position, work.plan.homogeneous
                                                               ? DirectionMap::all(cells)
                                                               : light.table->map().resized(cells));
    }
    clock.finish("shadow_map");
  }
  return [this, &work, lights = std::move(lights)](auto gaussians, const TileRays& rays,
                                                   const TileAirlight& out) {
    return sliced_airlight(prepared.medium(), gaussians, lights, scattered_environment(work), rays,
                           work.settings.slices, out);
  };
}

TileMethod Renderer::Impl::march(const Work& work) const {
  std::vector<MarchedLight> lights;
  for (const PointLight& light : work.plan.lights) {
    lights.push_back({light.position, light.intensity,
                      least_light_distance(work.rays, work.camera, light.position)});
  }
  return [this, &work, lights = std::move(lights)](auto gaussians, const TileRays& rays,
                                                   const TileAirlight& out) {
    return marched_airlight(prepared.medium(), gaussians, prepared.visibility(), lights,
                            scattered_environment(work), rays, work.settings.march_steps, out);
  };
}

TileMethod Renderer::Impl::reference(Work& work) const {
  std::vector<ReferenceLight> lights;
  for (const PointLight& light : work.plan.lights) {
    lights.push_back({light.position, light.intensity,
                      least_light_distance(work.rays, work.camera, light.position)});
  }
  std::optional<ReferenceEnvironment> environment;
  if (work.plan.environment) {
    environment.emplace(*work.scene.environment, work.scene.optics.anisotropy, fog_depth(work),
                        work.settings.reference_tolerance);
  }
  return [this, &work, lights = std::move(lights), environment = std::move(environment)](
             auto, const TileRays& rays, const TileAirlight& out) {
    std::uint64_t view_pairs = 0;
    std::uint64_t light_pairs = 0;
    for (std::size_t k = 0; k < rays.directions.size(); ++k) {
      if (work.job.stop.stop_requested()) break;
      const ReferenceRay ray = reference_airlight(
          prepared.medium(), prepared.occluders(), lights, environment ? &*environment : nullptr,
          rays.eye, rays.directions[k], rays.lengths[k], work.settings.reference_tolerance);
      out.airlight[k] = glm::vec3(ray.airlight);
      out.depths[k] = ray.depth;
      view_pairs += ray.view_pairs;
      light_pairs += ray.light_pairs;
    }
    std::atomic_ref(work.frame.statistics.light_pairs) += light_pairs;
    return view_pairs;
  };
}

void Renderer::Impl::shade_surfaces(Work& work) {
  const Settings::Arithmetic arithmetic = work.settings.airlight == AirlightMethod::reference
                                              ? Settings::Arithmetic::plain_double
                                              : work.settings.arithmetic;
  SurfaceLighting lighting;
  lighting.environment = shading.environment();
  lighting.albedo = work.albedo;
  if (lighting.environment) {
    lighting.fog_depth = fog_depth(work);
    if (source.has_receivers() && work.settings.airlight != AirlightMethod::paper) {
      lighting.arriving = &source.grid();
    }
  }
  if (work.plan.scattered_on_surfaces) {
    const bool paper = work.settings.paper_spread;
    lighting.point = paper ? &ScatterTable::paper() : &ScatterTable::point();
    lighting.distant = paper ? &ScatterTable::paper() : &ScatterTable::distant();
  }
  std::vector<SurfaceLight>& lights = lighting.lights;
  for (const PointLight& light : work.plan.lights) {
    lights.push_back({light, prepared.medium().density(light.position)});
    if (work.settings.airlight == AirlightMethod::sliced && work.plan.gaussians) {
      lights.back().table = &prepared.light_table(light.position, work.settings.light_table,
                                                  work.frame.statistics.light_pairs);
    }
  }
  shading.take_light(work.scene, prepared.medium(), lighting, work.settings, arithmetic, work.job,
                     work.frame.statistics.light_pairs);
  const FilmSurfaces film{
      work.scene.surfaces, prepared.medium(), prepared.visibility(), shading, lighting, work.rays,
      work.frame.film,     arithmetic};
  work.frame.statistics.light_pairs += film.shade(hits, work.job, surface_radiance);
}

// Eq. 29. An environment is what is seen where nothing is hit.
void Renderer::Impl::composite(Work& work) const {
  Frame& frame = work.frame;
  const EnvironmentLight* environment = shading.environment();
  const auto width = static_cast<std::size_t>(frame.film.width);
  work.job.each(static_cast<std::size_t>(frame.film.height), [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t i = y * width + x;
      const float transmittance = frame.transmittance[3 * i];
      const bool is_open = !std::isfinite(frame.depth[i]);
      glm::vec3 behind = surface_radiance.empty() ? glm::vec3(0.0f) : surface_radiance[i];
      if (environment && is_open) {
        behind = environment->radiance(glm::vec3(
            work.rays.direction(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5)));
      }
      for (std::size_t k = 0; k < 3; ++k) {
        frame.beauty[4 * i + k] =
            finite(frame.airlight[3 * i + k] + transmittance * behind[static_cast<int>(k)]);
      }
      frame.beauty[4 * i + 3] = is_open ? 1.0f - transmittance : 1.0f;
    }
  });
}

}  // namespace brume
