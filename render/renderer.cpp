#include "render/renderer.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <xmmintrin.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>

#include "render/albedo.h"
#include "render/cpu/marched_airlight.h"
#include "render/cpu/paper_airlight.h"
#include "render/cpu/path_depths.h"
#include "render/cpu/sliced_airlight.h"
#include "render/cpu/surfaces.h"
#include "render/cpu/visibility.h"
#include "render/light_limits.h"
#include "render/medium_index.h"
#include "render/prepared_scene.h"
#include "render/reference/reference_airlight.h"
#include "render/render_plan.h"
#include "render/tiles.h"

namespace brume {
namespace {

// While one lives, its thread flushes denormals: they are far below every tolerance, slow, and
// Embree expects it.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

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

float finite(double x) {
  // The frame promises finite values: radiance beyond float is as bright as can be, and a broken
  // sum black.
  constexpr double most = 1e30;
  return std::isnan(x) ? 0.0f : static_cast<float>(std::clamp(x, 0.0, most));
}

}  // namespace

struct Renderer::Impl {
  PreparedScene prepared;

  // One frame's state, stage by stage.
  struct Work {
    const Scene& scene;
    const Camera& camera;
    const Settings& settings;
    const std::stop_token& stop;
    const std::function<void(double)>& progress;
    RenderPlan plan;
    CameraRays rays;
    Tiles tiles;
    Frame frame;
    std::vector<SurfaceHit> hits;
    std::vector<glm::dvec3> surface_radiance;
    std::vector<double> depths;  // T(v, p)

    [[nodiscard]] std::size_t pixel(int x, int y) const {
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
             static_cast<std::size_t>(x);
    }
  };

  std::optional<Frame> render(Work& work);
  void find_surfaces(Work& work) const;
  PaperLights paper_lights(Work& work, StageClock& clock);
  void paper(Work& work, StageClock& clock);
  void sliced(Work& work, StageClock& clock);
  void march(Work& work) const;
  template <class Method>
  void tile_airlight(Work& work, Method method) const;
  void reference(Work& work) const;
  void shade_surfaces(Work& work) const;
  static void composite(Work& work);

  // Runs body(tile) for all tiles in parallel until a stop is requested.
  template <class Body>
  static void each_tile(const Work& work, bool report, Body body) {
    std::atomic<std::size_t> done = 0;
    std::mutex mutex;
    tbb::parallel_for(std::size_t{0}, work.tiles.count(), [&](std::size_t tile) {
      if (work.stop.stop_requested()) return;
      const FlushDenormals flush;
      body(tile);
      if (!report || !work.progress) return;
      ++done;
      const std::scoped_lock lock(mutex);
      work.progress(static_cast<double>(done) / static_cast<double>(work.tiles.count()));
    });
  }

  // Calls visit(pixel index, x, y) for the pixels of a tile, row by row.
  template <class Visit>
  static void each_pixel(const Work& work, std::size_t tile, Visit visit) {
    const auto r = work.tiles.rectangle(tile);
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0; x < r.x1; ++x) visit(work.pixel(x, y), x, y);
    }
  }
};

Renderer::Renderer() = default;
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

std::optional<Frame> Renderer::render(const Scene& scene, const Camera& camera, const Film& film,
                                      const Settings& settings, std::stop_token stop,
                                      const std::function<void(double)>& progress) {
  tbb::task_arena arena(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic);
  const auto render_one = [&](const Scene& of, std::size_t which) {
    Impl::Work work{of,
                    camera,
                    settings,
                    stop,
                    progress,
                    RenderPlan(of, settings.airlight),
                    CameraRays(camera, film),
                    Tiles(film),
                    {},
                    {},
                    {},
                    {}};
    work.frame.film = film;
    return arena.execute([&] { return impls_[which]->render(work); });
  };

  const std::vector<AlbedoGroup> groups = albedo_groups(scene.optics.albedo);
  while (impls_.size() < groups.size()) impls_.push_back(std::make_unique<Impl>());
  impls_.resize(groups.size());
  if (groups.size() == 1 && groups[0].albedo == 1.0) return render_one(scene, 0);

  std::optional<Frame> frame;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Scene absorbing = scene;
    absorbing.medium = extinction_medium(scene.medium, groups[i].albedo);
    std::optional<Frame> part = render_one(absorbing, i);
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
  StageClock clock(statistics.stages);
  const auto pixels = static_cast<std::size_t>(work.frame.film.width) *
                      static_cast<std::size_t>(work.frame.film.height);
  work.frame.beauty.resize(4 * pixels);
  work.frame.airlight.resize(3 * pixels);
  work.frame.transmittance.resize(3 * pixels);
  work.frame.depth.assign(pixels, std::numeric_limits<float>::infinity());
  work.hits.resize(pixels);
  work.surface_radiance.assign(pixels, glm::dvec3(0.0));
  work.depths.assign(pixels, 0.0);
  statistics.skipped = work.plan.skipped;
  statistics.gaussians_total = work.scene.medium.size();

  prepared.update(work.scene, work.plan.lights, work.settings);
  clock.finish("prepare");
  if (work.plan.surfaces) {
    find_surfaces(work);
    clock.finish("visibility");
  }
  if (work.plan.gaussians || work.plan.homogeneous) {
    switch (work.settings.airlight) {
      case AirlightMethod::paper:
        paper(work, clock);
        break;
      case AirlightMethod::sliced:
        sliced(work, clock);
        break;
      case AirlightMethod::march:
        march(work);
        break;
      case AirlightMethod::reference:
        reference(work);
        break;
    }
    // Without light there is still what the medium takes away.
    clock.finish(work.plan.airlight ? "airlight" : "transmittance");
  }
  if (work.plan.lit_surfaces) {
    shade_surfaces(work);
    clock.finish("surfaces");
  }
  if (work.stop.stop_requested()) return std::nullopt;
  composite(work);
  clock.finish("composite");
  statistics.frame_milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return std::move(work.frame);
}

void Renderer::Impl::find_surfaces(Work& work) const {
  each_tile(work, false, [&](std::size_t tile) {
    each_pixel(work, tile, [&](std::size_t i, int x, int y) {
      work.hits[i] =
          prepared.visibility().first_hit(work.rays.eye(), work.rays.direction(x + 0.5, y + 0.5));
      work.frame.depth[i] = static_cast<float>(work.hits[i].distance);
    });
  });
}

PaperLights Renderer::Impl::paper_lights(Work& work, StageClock& clock) {
  const MediumIndex& medium = prepared.medium();
  const Settings::Arithmetic arithmetic = work.settings.arithmetic;
  const glm::dvec3& eye = work.rays.eye();
  PaperLights paper;
  paper.at_mean = work.settings.paper.at_mean;
  if (!work.plan.airlight) return paper;
  for (const PointLight& light : work.plan.lights) {
    PaperLight& l = paper.lights.emplace_back();
    l.position = light.position;
    l.intensity = light.intensity;
    l.h_min = least_light_distance(work.rays, work.camera, light.position);
  }
  if (!work.plan.gaussians) return paper;

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
  return paper;
}

// Runs method(list of Gaussians, rays, out) -> pairs on every tile.
template <class Method>
void Renderer::Impl::tile_airlight(Work& work, Method method) const {
  const Tiles::Lists lists = work.tiles.lists(prepared.medium(), work.rays);
  work.frame.statistics.gaussians_used = lists.used;
  std::atomic<std::uint64_t> pairs = 0;
  each_tile(work, true, [&](std::size_t tile) {
    std::array<glm::dvec3, Tiles::pixels> directions;
    std::array<double, Tiles::pixels> lengths;
    std::array<glm::vec3, Tiles::pixels> airlight;
    std::array<double, Tiles::pixels> depths;
    std::size_t count = 0;
    each_pixel(work, tile, [&](std::size_t i, int x, int y) {
      directions[count] = work.rays.direction(x + 0.5, y + 0.5);
      lengths[count++] = work.hits[i].distance;
    });
    const TileRays rays{work.rays.eye(), std::span(directions).first(count),
                        std::span(lengths).first(count)};
    pairs += method(lists.of(tile), rays,
                    TileAirlight{std::span(airlight).first(count), std::span(depths).first(count)});
    count = 0;
    each_pixel(work, tile, [&](std::size_t i, int, int) {
      work.depths[i] = depths[count];
      for (int k = 0; k < 3; ++k) {
        work.frame.airlight[3 * i + static_cast<std::size_t>(k)] = finite(airlight[count][k]);
      }
      ++count;
    });
  });
  work.frame.statistics.view_pairs += pairs;
}

void Renderer::Impl::paper(Work& work, StageClock& clock) {
  const PaperLights lights = paper_lights(work, clock);
  tile_airlight(work, [&](auto gaussians, const TileRays& rays, const TileAirlight& out) {
    return paper_airlight(prepared.medium(), gaussians, lights, rays, work.settings.arithmetic,
                          out);
  });
}

void Renderer::Impl::sliced(Work& work, StageClock& clock) {
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
      light.shadows = &prepared.shadow_map(
          light.position, work.plan.homogeneous ? DirectionMap::all(cells)
                                                : light.table->map().resized(cells));
    }
    clock.finish("shadow_map");
  }
  tile_airlight(work, [&](auto gaussians, const TileRays& rays, const TileAirlight& out) {
    return sliced_airlight(prepared.medium(), gaussians, lights, rays, work.settings.slices, out);
  });
}

void Renderer::Impl::march(Work& work) const {
  std::vector<MarchedLight> lights;
  for (const PointLight& light : work.plan.lights) {
    lights.push_back({light.position, light.intensity,
                      least_light_distance(work.rays, work.camera, light.position)});
  }
  tile_airlight(work, [&](auto gaussians, const TileRays& rays, const TileAirlight& out) {
    return marched_airlight(prepared.medium(), gaussians, prepared.visibility(), lights, rays,
                            work.settings.march_steps, out);
  });
}

void Renderer::Impl::reference(Work& work) const {
  std::vector<ReferenceLight> lights;
  for (const PointLight& light : work.plan.lights) {
    lights.push_back({light.position, light.intensity,
                      least_light_distance(work.rays, work.camera, light.position)});
  }
  std::atomic<std::uint64_t> view_pairs = 0;
  std::atomic<std::uint64_t> light_pairs = 0;
  each_tile(work, true, [&](std::size_t tile) {
    each_pixel(work, tile, [&](std::size_t i, int x, int y) {
      if (work.stop.stop_requested()) return;
      const ReferenceRay ray =
          reference_airlight(prepared.medium(), prepared.occluders(), lights, work.rays.eye(),
                             work.rays.direction(x + 0.5, y + 0.5), work.hits[i].distance,
                             work.settings.reference_tolerance);
      work.depths[i] = ray.depth;
      for (int k = 0; k < 3; ++k) {
        work.frame.airlight[3 * i + static_cast<std::size_t>(k)] = finite(ray.airlight[k]);
      }
      view_pairs += ray.view_pairs;
      light_pairs += ray.light_pairs;
    });
  });
  work.frame.statistics.gaussians_used = prepared.medium().size();
  work.frame.statistics.view_pairs = view_pairs;
  work.frame.statistics.light_pairs += light_pairs;
}

void Renderer::Impl::shade_surfaces(Work& work) const {
  const Settings::Arithmetic arithmetic = work.settings.airlight == AirlightMethod::reference
                                              ? Settings::Arithmetic::plain_double
                                              : work.settings.arithmetic;
  std::atomic<std::uint64_t> pairs = 0;
  each_tile(work, false, [&](std::size_t tile) {
    std::array<SurfacePoint, Tiles::pixels> points;
    std::array<std::size_t, Tiles::pixels> pixels;
    std::array<glm::dvec3, Tiles::pixels> radiance;
    std::size_t count = 0;
    each_pixel(work, tile, [&](std::size_t i, int x, int y) {
      if (!work.hits[i]) return;
      pixels[count] = i;
      points[count++] =
          prepared.visibility().point(work.hits[i], work.rays.eye(),
                                      work.rays.direction(x + 0.5, y + 0.5), work.scene.surfaces);
    });
    pairs += surface_radiance(prepared.medium(), prepared.visibility(), work.plan.lights,
                              std::span(points).first(count), arithmetic,
                              std::span(radiance).first(count));
    for (std::size_t k = 0; k < count; ++k) work.surface_radiance[pixels[k]] = radiance[k];
  });
  work.frame.statistics.light_pairs += pairs;
}

void Renderer::Impl::composite(Work& work) {
  Frame& frame = work.frame;
  tbb::parallel_for(std::size_t{0}, work.depths.size(), [&](std::size_t i) {
    const double transmittance = std::exp(-work.depths[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      frame.transmittance[3 * i + k] = finite(transmittance);
      const double surface = work.surface_radiance[i][static_cast<int>(k)];
      frame.beauty[4 * i + k] =
          finite(static_cast<double>(frame.airlight[3 * i + k]) + transmittance * surface);
    }
    frame.beauty[4 * i + 3] = work.hits[i] ? 1.0f : finite(1.0 - transmittance);
  });
}

}  // namespace brume
