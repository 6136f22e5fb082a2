#include <algorithm>
#include <array>
#include <utility>

#include "brume/at_time.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "brume/render.h"
#include "core/number_domain.h"
#include "core/scene/check.h"
#include "render/gl_renderer.h"
#include "render/layers/frame_layers.h"
#include "render/output/frame_file.h"
#include "render/render_plan.h"
#include "render/shot.h"
#include "render/transfer/transfer_cache.h"
#include "render/transfer/transfer_store.h"

namespace brume {
namespace {

void check_count(const char* name, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw DomainError(name, "found " + std::to_string(value) + "; allowed: " + std::to_string(low) +
                              " to " + std::to_string(high));
}

void check(const RenderRequest& request) {
  constexpr NumberDomain error{1e-4, 10.0, "a number from 1e-4 to 10"};
  const auto check_number = [](const char* name, double value, const NumberDomain& domain) {
    if (!domain.contains(value)) throw DomainError(name, domain.refusal(value));
  };
  if (request.film) check_film("film", *request.film);
  if (request.camera) brume::check(*request.camera);
  check_number("time", request.time, domain::seconds);
  check_number("max_error", request.max_error, error);
  check_count("slices", request.slices, 4, 256);
  check_count("march_steps", request.march_steps, 1, 65'536);
  check_count("paths", request.paths, 1, limits::paths);
  if (request.samples) check_count("samples", *request.samples, 1, limits::samples);
  check_count("threads", request.threads, 0, 1024);
  if (request.shutter) {
    check_number("shutter.open", request.shutter->open, domain::shutter);
    check_number("shutter.close", request.shutter->close, domain::shutter);
    if (!(request.shutter->open < request.shutter->close)) {
      throw DomainError("shutter", "allowed: one that opens before it closes");
    }
  }
}

Settings settings_of(const RenderRequest& request) {
  Settings settings = sliced_settings({}, request.slices);
  settings.airlight = request.airlight;
  settings.max_error = request.max_error;
  settings.scattering = request.scattering;
  settings.march_steps = request.march_steps;
  settings.paths = request.paths;
  settings.path_seed = request.seed;
  settings.threads = request.threads;
  if (request.airlight == AirlightMethod::auto_) settings.airlight_scale = 4;
  return settings;
}

// Whether evaluate_at() would only copy the scene, and with it all Gaussians.
bool is_evaluated(const Scene& scene, double time) {
  return time == scene.time && !is_animated(scene) && scene.groups.empty() &&
         scene.emitters.empty() && scene.sequences.empty() &&
         std::ranges::all_of(scene.surfaces, [](const Surface& surface) {
           return surface.visible && !surface.imported;
         });
}

// Whether a method is itself what errors are measured against.
bool is_truth(AirlightMethod method) {
  return method == AirlightMethod::path || method == AirlightMethod::reference;
}

}  // namespace

struct SceneRenderer::Impl {
  FrameRenderer& of(Backend backend, std::vector<std::string>& warnings) {
    auto& [renderer, problem] = renderers[static_cast<std::size_t>(backend)];
    if (!renderer) renderer = make_renderer(backend, transfers, problem);
    if (!problem.empty()) warnings.push_back("rendered on the CPU: " + problem);
    return *renderer;
  }

  std::shared_ptr<TransferStore> transfers = std::make_shared<TransferStore>();
  std::array<std::pair<std::unique_ptr<FrameRenderer>, std::string>, 3> renderers;  // by Backend
};

SceneRenderer::SceneRenderer() : impl_(std::make_unique<Impl>()) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

std::optional<Frame> SceneRenderer::render(const Scene& animation, const RenderRequest& request,
                                           const std::stop_token& stop,
                                           const std::function<void(double)>& progress) {
  brume::check(animation);
  check(request);
  const Job job{stop, progress};
  std::optional<Scene> evaluated;
  if (!is_evaluated(animation, request.time)) evaluated = evaluate_at(animation, request.time);
  const Scene& scene = evaluated ? *evaluated : animation;
  const Film film = request.film.value_or(animation.film);
  const Settings settings = settings_of(request);
  std::vector<std::string> warnings;
  if (request.airlight != AirlightMethod::path) {
    impl_->transfers->make(needed_transfers(scene, settings), cache_folder(),
                           job.subrange(0.0, 0.1), &warnings);
    if (stop.stop_requested()) return std::nullopt;
  }
  FrameRenderer& renderer = impl_->of(request.backend, warnings);
  Shot shot{animation, scene, request.camera, film, exposure_of(animation)};
  if (request.samples) shot.exposure.samples = request.samples;
  if (request.shutter) shot.exposure.shutter = request.shutter;
  std::optional<RequestedFrame> found =
      render_shot(renderer, shot, settings, job.subrange(0.1, 0.8));
  if (!found) return std::nullopt;

  Frame frame = std::move(found->frame);
  frame.statistics.airlight = airlight_name(found->settings);
  if (found->settings.airlight == AirlightMethod::sliced) {
    frame.statistics.airlight += ":" + std::to_string(found->settings.slices);
  }
  frame.error = found->error;
  if (!frame.error && request.measure_error && !is_truth(request.airlight)) {
    frame.error =
        measure_error(scene, shot.seen_by(), frame, stop, job.subrange(0.8, 0.9).progress);
    if (!frame.error) return std::nullopt;
  }
  if (frame.error && request.airlight == AirlightMethod::auto_ &&
      frame.error->high > request.max_error) {
    warnings.push_back("no setting is certain to meet max_error");
  }
  if (has_more_layers(request.layers)) {
    const LayeredFrame layered{
        animation,
        scene,
        request.camera ? &*request.camera : nullptr,
        found->settings,
        render_lit_by(renderer, {shot.moments(), scene.time, request.camera, film, shot.exposure}),
        frame};
    std::optional<ImageLayers> layers =
        render_layers(layered, request.layers, job.subrange(0.9, 1.0));
    if (!layers) return std::nullopt;
    frame.layers = std::move(*layers);
  }
  frame.layers.metadata.merge(settings_metadata(found->settings));
  frame.warnings = std::move(warnings);
  if (progress) progress(1.0);
  return frame;
}

std::optional<Frame> render(const Scene& scene, const RenderRequest& request,
                            const std::stop_token& stop,
                            const std::function<void(double)>& progress) {
  return SceneRenderer().render(scene, request, stop, progress);
}

}  // namespace brume
