#include "render/deep/deep_renderer.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "render/cpu/composite.h"
#include "render/cpu/film_airlight.h"
#include "render/cpu/film_slices.h"
#include "render/cpu/sliced_airlight.h"
#include "render/deep/deep_samples.h"
#include "render/prepare/albedo.h"
#include "render/prepare/frame_stages.h"
#include "render/render_plan.h"
#include "render/scattering/source_view.h"
#include "render/visibility/holdout.h"

namespace brume {
namespace {

// The share of the error that may be between points; samples are fit to the rest.
constexpr double share_between_points = 0.25;
constexpr std::size_t max_parts = 16;
constexpr std::size_t max_boundaries_of_tile = 2048;

// The stages of a frame of one albedo group.
class DeepGroup {
 public:
  DeepGroup(const RenderPlan& plan, Scene scene, const Camera& camera, const FilmWindow& window,
            const TransferStore& transfers, const Job& job, const AlbedoGroup& group,
            const FogExtent& extent)
      : scene_(std::move(scene)),
        work_(plan, scene_, camera, window, transfers, nullptr, job, group, extent) {}

  // False if stopped.
  bool prepare() {
    StageClock clock(work_.frame.statistics.stages);
    work_.make_layers();
    if (!stages_.begin(work_, clock)) return false;
    stages_.find_hits(work_, clock);
    if (!stages_.prepare_source(work_, clock)) return false;
    if (work_.plan.has_medium()) {
      lights_ =
          std::make_shared<const std::vector<SlicedLight>>(stages_.sliced_lights(work_, clock));
      const SourceFunction* const function = stages_.source_function(work_);
      if (function) {
        source_view_.update(*function, work_.rays, work_.job);
        source_ = {function, source_view_.lookup(*function), &function->eye_lobe()};
      }
      tiles_.emplace(work_.frame.film);
      lists_ = tiles_->lists(medium(), work_.rays);
      work_.set_mirrored_ways(sliced_airlight_along(medium(), lights_, function,
                                                    work_.settings.slices, work_.group.albedo));
    } else {
      work_.set_mirrored_ways({});
    }
    surfaces_ = stages_.shade_surfaces(work_, clock);
    return !work_.job.stop.stop_requested();
  }

  void choose_slices(FilmSlices& slices) const {
    const RayEnds ends = stages_.ray_ends(work_);
    const FilmTiles film{*tiles_, lists_, work_.rays, ends, work_.frame, work_.window, 1};
    slices.choose(film, medium(), stages_.lit_from(work_, *lights_), work_.settings.slices,
                  work_.job);
  }

  void evaluate(const TileRays& rays, const SliceNodes& nodes, const TileAirlight& out,
                TileProfiles& profiles) const {
    sliced_airlight(medium(), lists_.gaussians_of(rays.tile), *lights_,
                    source_ ? &*source_ : nullptr, rays, nodes, out, &profiles);
  }

  void behind(std::size_t row, std::span<glm::vec3> radiance) const {
    behind_medium(work_.rays, stages_.shading().environment(), surfaces_, work_.frame, row,
                  radiance);
  }

  [[nodiscard]] bool is_held_out(std::size_t pixel) const {
    return work_.plan.runs(Stage::visibility) &&
           brume::is_held_out(work_.scene.surfaces, stages_.hit(pixel));
  }

  [[nodiscard]] const MediumIndex& medium() const { return stages_.prepared().medium(); }
  [[nodiscard]] const FrameContext& work() const { return work_; }
  // To the surface, or to the end of fog [u].
  [[nodiscard]] double distance(std::size_t pixel) const {
    return stages_.ray_ends(work_).distance(work_.frame.depth, pixel);
  }

 private:
  Scene scene_;
  FrameContext work_;
  FrameStages stages_;
  std::shared_ptr<const std::vector<SlicedLight>> lights_ =
      std::make_shared<const std::vector<SlicedLight>>();
  SourceView source_view_;
  std::optional<SlicedSource> source_;
  std::optional<Tiles> tiles_;
  Tiles::Lists lists_;
  std::span<const glm::vec3> surfaces_;
};

using DeepGroups = std::vector<std::unique_ptr<DeepGroup>>;

// The rays of one tile.
struct DeepTile {
  std::size_t count = 0;
  std::array<std::size_t, Tiles::pixels> pixels;
  std::array<glm::dvec3, Tiles::pixels> directions, offsets;
  std::array<double, Tiles::pixels> lengths;
  std::array<glm::vec2, Tiles::pixels> positions;
  std::vector<TileProfiles> profiles;  // of the groups
  std::array<glm::vec3, Tiles::pixels> airlight;
  std::vector<std::array<double, Tiles::pixels>> depths;  // of the groups, to the rays' ends
};

class DeepFilm {
 public:
  DeepFilm(const DeepGroups& groups, const DeepSettings& deep)
      : groups_(groups),
        deep_(deep),
        film_(groups[0]->work().frame.film),
        region_(groups[0]->work().window.region()),
        tiles_(film_) {
    if (groups[0]->work().plan.has_medium()) groups[0]->choose_slices(slices_);
  }

  // False if stopped.
  bool render(const TakeDeepRows& take, const Job& job) {
    const auto width = static_cast<std::size_t>(film_.width);
    std::vector<std::vector<DeepSample>> samples(width * Tiles::height);
    DeepRows rows;
    const int first_row = region_.y0 / Tiles::height;
    const int end_row = (region_.y1 + Tiles::height - 1) / Tiles::height;
    for (int row = first_row; row < end_row; ++row) {
      const int first = std::max(row * Tiles::height, region_.y0);
      const int end = std::min((row + 1) * Tiles::height, region_.y1);
      for (std::vector<DeepSample>& pixel : samples) pixel.clear();
      const int first_column = region_.x0 / Tiles::width;
      const int end_column = (region_.x1 + Tiles::width - 1) / Tiles::width;
      job.parallel_for(static_cast<std::size_t>(end_column - first_column), [&](std::size_t k) {
        const int tile = row * tiles_.columns() + first_column + static_cast<int>(k);
        fill(static_cast<std::size_t>(tile), row * Tiles::height, samples);
      });
      const auto row_samples = [&](int y) {
        return std::span(samples).subspan(static_cast<std::size_t>(y % Tiles::height) * width,
                                          width);
      };
      job.parallel_for(static_cast<std::size_t>(end - first), [&](std::size_t k) {
        const int y = first + static_cast<int>(k);
        add_behind(static_cast<std::size_t>(y), row_samples(y));
      });
      if (job.stop.stop_requested()) return false;
      rows.first = first - region_.y0;
      rows.counts.clear();
      rows.samples.clear();
      for (int y = first; y < end; ++y) {
        const auto columns = static_cast<std::size_t>(region_.x1 - region_.x0);
        for (const std::vector<DeepSample>& pixel :
             row_samples(y).subspan(static_cast<std::size_t>(region_.x0), columns)) {
          rows.counts.push_back(static_cast<std::uint32_t>(pixel.size()));
          rows.samples.insert(rows.samples.end(), pixel.begin(), pixel.end());
          statistics_.max_samples = std::max(statistics_.max_samples, pixel.size());
        }
      }
      statistics_.pixels += rows.counts.size();
      statistics_.samples += rows.samples.size();
      take(rows);
      if (job.progress) job.progress((row + 1.0 - first_row) / (end_row - first_row));
    }
    statistics_.coarse_tiles = coarse_tiles_;
    return true;
  }

  [[nodiscard]] const DeepStatistics& statistics() const { return statistics_; }

 private:
  // The samples of fog of a tile's pixels.
  void fill(std::size_t tile, int first_row, std::vector<std::vector<DeepSample>>& samples) {
    if (!groups_[0]->work().plan.has_medium()) return;
    const SliceNodes nodes = slices_.nodes(tile);
    if (nodes.count < 2) return;
    thread_local DeepTile work;
    gather_rays(tile, work);
    thread_local std::vector<RayProfile> rays;
    rays.resize(work.count);
    work.profiles.resize(groups_.size());
    work.depths.resize(groups_.size());
    for (std::size_t parts = 1;; parts *= 2) {
      evaluate(tile, nodes, parts, work);
      double error = 0.0;
      for (std::size_t i = 0; i < work.count; ++i) {
        set_profile(work, i, rays[i]);
        error = std::max(error, error_between_points(rays[i], tolerance(rays[i], deep_.error)));
      }
      if (error <= share_between_points) break;
      if (parts == max_parts || nodes.count * parts * 4 > max_boundaries_of_tile) {
        ++coarse_tiles_;
        break;
      }
    }
    const std::size_t first =
        static_cast<std::size_t>(first_row) * static_cast<std::size_t>(film_.width);
    for (std::size_t i = 0; i < work.count; ++i) {
      fit_deep_samples(rays[i], tolerance(rays[i], (1.0 - share_between_points) * deep_.error),
                       samples[work.pixels[i] - first]);
    }
  }

  void gather_rays(std::size_t tile, DeepTile& work) const {
    const CameraRays& rays = groups_[0]->work().rays;
    const CameraRays::PixelRectangle rectangle = tiles_.rectangle(tile);
    const glm::vec2 size(Tiles::width, Tiles::height);
    work.count = 0;
    Tiles::each_pixel(rectangle, [&](int x, int y) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(film_.width) +
          static_cast<std::size_t>(x);
      work.pixels[work.count] = pixel;
      work.lengths[work.count] = groups_[0]->distance(pixel);
      work.positions[work.count] = glm::vec2(x - rectangle.x0, y - rectangle.y0) / size;
      work.offsets[work.count] = rays.offset(x + 0.5, y + 0.5);
      work.directions[work.count++] = rays.direction(x + 0.5, y + 0.5);
    });
  }

  void evaluate(std::size_t tile, const SliceNodes& nodes, std::size_t parts,
                DeepTile& work) const {
    const CameraRays& view = groups_[0]->work().rays;
    const TileRays rays{view.eye(),
                        std::span(work.directions).first(work.count),
                        std::span(work.lengths).first(work.count),
                        tile,
                        std::span(work.positions).first(work.count),
                        std::span(work.offsets).first(view.is_parallel() ? work.count : 0)};
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      work.profiles[g].parts = parts;
      groups_[g]->evaluate(
          rays, nodes,
          {std::span(work.airlight).first(work.count), std::span(work.depths[g]).first(work.count)},
          work.profiles[g]);
    }
  }

  // Sets the profile of ray i. Points half-way between those of the airlight get as much of it as
  // they lose of the transmittance, as if all between were lit alike.
  void set_profile(const DeepTile& work, std::size_t i, RayProfile& ray) const {
    ray.clear();
    const std::size_t points = 2 * (work.profiles[0].count - 1) + 1;
    glm::dvec3 before(0.0);
    for (std::size_t j = 0; j < points; ++j) {
      glm::dvec3 depth(0.0);
      glm::dvec3 light(0.0);
      for (std::size_t g = 0; g < groups_.size(); ++g) {
        const TileProfiles& profiles = work.profiles[g];
        const AlbedoGroup& group = groups_[g]->work().group;
        const auto depth_at = [&](std::size_t k) { return profiles.depths[k * work.count + i]; };
        double share = 0.0;
        if (j % 2 == 1) {
          const double all = std::expm1(depth_at(j - 1) - depth_at(j + 1));
          share = all < 0.0 ? std::expm1(depth_at(j - 1) - depth_at(j)) / all : 0.5;
        }
        for (const std::size_t channel : group.channels) {
          const int c = static_cast<int>(channel);
          const auto light_at = [&](std::size_t k) {
            return group.albedo * static_cast<double>(profiles.airlight[k * work.count + i][c]);
          };
          depth[c] = depth_at(j);
          light[c] = j % 2 == 0 ? light_at(j / 2)
                                : light_at(j / 2) + share * (light_at(j / 2 + 1) - light_at(j / 2));
        }
      }
      before = glm::max(before, light);
      ray.add(work.profiles[0].distances[j * work.count + i], depth, before);
    }
    add_fog_behind(work, i, ray);
  }

  // Homogeneous fog goes on behind the last slice, where no light comes from any more.
  void add_fog_behind(const DeepTile& work, std::size_t i, RayProfile& ray) const {
    const auto end = static_cast<float>(work.lengths[i]);
    if (!std::isfinite(end) || !(end > ray.distances.back())) return;
    glm::dvec3 depth = ray.depths.back();
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      for (const std::size_t channel : groups_[g]->work().group.channels) {
        const int c = static_cast<int>(channel);
        depth[c] = std::max(depth[c], work.depths[g][i]);
      }
    }
    if (depth == ray.depths.back()) return;
    const glm::dvec3 light = ray.airlight.back();
    const double last = static_cast<double>(ray.distances.back());
    const auto middle = static_cast<float>(0.5 * (last + static_cast<double>(end)));
    ray.add(middle, 0.5 * (ray.depths.back() + depth), light);
    ray.add(end, depth, light);
  }

  [[nodiscard]] DeepTolerance tolerance(const RayProfile& ray, double error) const {
    return {error, error * glm::max(ray.airlight.back(), deep_.airlight_rms)};
  }

  // Surfaces, and the environment behind everything, of a row.
  void add_behind(std::size_t row, std::span<std::vector<DeepSample>> samples) const {
    const std::size_t width = samples.size();
    std::vector<glm::vec3> radiance(width, glm::vec3(0.0f));
    std::vector<glm::vec3> of_group(width);
    for (const std::unique_ptr<DeepGroup>& group : groups_) {
      group->behind(row, of_group);
      for (std::size_t x = 0; x < width; ++x) {
        for (const std::size_t channel : group->work().group.channels) {
          const int c = static_cast<int>(channel);
          radiance[x][c] = finite(of_group[x][c]);
        }
      }
    }
    for (std::size_t x = 0; x < width; ++x) {
      const float distance = groups_[0]->work().frame.depth[row * width + x];
      if (std::isfinite(distance)) {
        for (DeepSample& fog : samples[x]) {
          fog.z = std::min(fog.z, distance);
          fog.z_back = std::min(fog.z_back, distance);
        }
        if (groups_[0]->is_held_out(row * width + x)) continue;
        samples[x].push_back({distance, distance, radiance[x], glm::vec3(1.0f), 1.0f});
      } else if (radiance[x] != glm::vec3(0.0f)) {
        samples[x].push_back(
            {deep_background, deep_background, radiance[x], glm::vec3(0.0f), 0.0f});
      }
    }
  }

  const DeepGroups& groups_;
  const DeepSettings& deep_;
  Film film_;                          // of the window
  CameraRays::PixelRectangle region_;  // that is asked for
  Tiles tiles_;
  FilmSlices slices_;
  DeepStatistics statistics_;
  std::atomic<std::size_t> coarse_tiles_ = 0;
};

}  // namespace

bool has_colored_alpha(const Scene& scene) {
  return albedo_groups(scene).size() > 1;
}

std::optional<DeepStatistics> render_deep(const Scene& scene, const Camera& camera,
                                          const Film& film, const DeepSettings& deep,
                                          const TransferStore& transfers, const TakeDeepRows& take,
                                          const Job& job) {
  Settings settings = deep.settings;
  settings.airlight = AirlightMethod::sliced;
  settings.airlight_scale = 1;
  settings.samples = 1;
  const RenderPlan plan(scene, film, settings, &transfers);
  const FogExtent extent(scene);
  const FilmWindow window(film, settings);
  const std::vector<AlbedoGroup> albedos = albedo_groups(scene, plan.has_own_optics);
  DeepGroups groups;
  for (std::size_t g = 0; g < albedos.size(); ++g) {
    Scene absorbing = scene;
    absorbing.medium = extinction_medium(scene, albedos[g]);
    groups.push_back(std::make_unique<DeepGroup>(plan, std::move(absorbing), camera, window,
                                                 transfers, Job{job.stop, {}}, albedos[g], extent));
    if (!groups.back()->prepare()) return std::nullopt;
  }
  DeepFilm deep_film(groups, deep);
  if (!deep_film.render(take, job)) return std::nullopt;
  return deep_film.statistics();
}

}  // namespace brume
