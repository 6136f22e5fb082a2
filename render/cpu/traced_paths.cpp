#include "render/cpu/traced_paths.h"

#include <algorithm>
#include <utility>

namespace brume {
namespace {

// 1 for the channels of the frame's albedo group.
glm::dvec3 channels_of(const FrameContext& work) {
  glm::dvec3 channels(0.0);
  for (const std::size_t c : work.group.channels) channels[static_cast<int>(c)] = 1.0;
  return channels;
}

}  // namespace

void TracedPaths::prepare(const FrameStages& stages, const FrameContext& work) {
  const MediumIndex& index = stages.prepared().medium();
  if (!medium_ || medium_revision_ != index.revision()) {
    medium_ = std::make_unique<PathMedium>(index);
    medium_revision_ = index.revision();
  }
  if (!work.plan.has_environment) {
    environment_.reset();
  } else if (!environment_ || environment_->environment() != *work.scene.environment) {
    environment_.emplace(*work.scene.environment);
  }
}

std::span<const glm::vec3> TracedPaths::trace(const FrameStages& stages, FrameContext& work,
                                              std::function<float(std::size_t)> passing) {
  const bool is_lit = work.plan.runs(Stage::paths);
  if (!is_lit && !work.plan.has_medium()) return {};
  prepare(stages, work);

  const RayCaster& ray_caster = stages.prepared().ray_caster();
  PathScene scene =
      PathScene::of_view(*medium_, work.group.albedo, ray_caster, work.scene.surfaces,
                         environment_ ? &*environment_ : nullptr, work.sources(), work.rays.eye(),
                         work.fog_extent.ball(), work.rays.max_offset());

  scene.light_shapes = &work.light_shapes;
  scene.is_mirrored_alone = work.settings.mirrored_alone;

  PathKey key;
  key.medium = medium_revision_;
  key.noise = medium_->index().noise();
  key.albedo = work.group.albedo;
  key.lights = work.plan.lights;
  key.environment = work.scene.environment;
  key.surfaces = work.scene.surfaces;
  key.light_shapes = work.light_shapes.all();
  key.fog = scene.fog.ball;
  key.is_fog_everywhere = scene.fog.is_everywhere;
  key.camera = work.camera;
  key.film = work.frame.film;
  key.channels = channels_of(work);
  key.seed = work.settings.path_seed;
  key.is_mirrored_alone = scene.is_mirrored_alone;

  const PathFilm::View view{.scene = scene,
                            .rays = work.rays,
                            .pixels = work.window.region(),
                            .open_end = stages.ray_ends(work).open,
                            .hit = [&](std::size_t pixel) { return stages.hit(pixel); },
                            .passing = std::move(passing),
                            .paths = is_lit ? work.settings.paths : 0,
                            .has_medium = work.plan.has_medium(),
                            .has_surfaces = work.plan.runs(Stage::visibility)};
  film_.trace(key, view, work.job, work.frame);

  FrameStatistics& statistics = work.frame.statistics;
  const CameraRays::PixelRectangle& traced = work.window.region();
  statistics.exact_pixels = static_cast<std::size_t>(traced.x1 - traced.x0) *
                            static_cast<std::size_t>(traced.y1 - traced.y0);
  statistics.gaussians_used = static_cast<std::size_t>(std::ranges::count_if(
      medium_->index().cutoff_radii(), [](double radius) { return radius > 0.0; }));
  return film_.surfaces();
}

}  // namespace brume
