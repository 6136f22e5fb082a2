#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <sstream>
#include <utility>

#include "brume/at_time.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "brume/render.h"
#include "core/scene/imported_scene.h"
#include "render/deep/deep_file.h"
#include "render/gl_renderer.h"
#include "render/layers/frame_layers.h"
#include "render/prepare/fog_extent.h"
#include "render/quality/auto_quality.h"
#include "render/render_plan.h"
#include "render/request.h"
#include "render/samples/brightness.h"
#include "render/samples/denoised_frame.h"
#include "render/transfer/transfer_cache.h"
#include "render/transfer/transfer_store.h"

namespace brume {
namespace {

// Whether evaluate_at() would only copy the scene, and with it all Gaussians.
bool is_evaluated(const Scene& scene, double time) {
  const bool has_sky = scene.environment && scene.environment->sky;
  return time == scene.time && !is_animated(scene) && scene.groups.empty() &&
         scene.emitters.empty() && scene.sequences.empty() && !has_sky &&
         std::ranges::all_of(scene.surfaces, is_shown_as_it_is);
}

// What is measured: nothing of methods that errors are measured against.
ErrorMeasurement effort_of(const RenderRequest& request) {
  using enum ErrorMeasurement;
  const bool is_truth =
      (request.airlight == AirlightMethod::path && request.denoise == Denoising::none) ||
      request.airlight == AirlightMethod::reference;
  if (is_truth) return none;
  return request.error.value_or(request.airlight == AirlightMethod::auto_ ? quick : none);
}

void check_layer_memory(const Scene& scene, const Film& film, const OutputLayers& layers) {
  const std::size_t bytes = layer_bytes(scene, film, layers);
  if (bytes <= limits::scene_bytes) return;
  throw DomainError("layers", "they take " + std::to_string(bytes) + " bytes; allowed: at most " +
                                  std::to_string(limits::scene_bytes) +
                                  "; choose fewer, or a smaller size");
}

// Renders a view of a scene at its time. With `auto_`, settings are chosen, and with `full` the
// error is measured, of a frame without blur. nullopt if stopped.
std::optional<RequestedFrame> render_view(FrameRenderer& renderer, const Scene& scene,
                                          const ExposedView& view, Settings settings,
                                          Denoising denoise, ErrorMeasurement effort,
                                          const Job& job) {
  const Camera& camera = view.camera ? *view.camera : scene.camera;
  settings.samples = samples_of(view.exposure, camera, scene);
  const bool has_blur = is_blurred(view.exposure, camera);
  const bool is_auto = settings.airlight == AirlightMethod::auto_;
  RequestedFrame found{{}, settings, std::nullopt};
  if (is_auto && effort == ErrorMeasurement::full) {
    Settings wanted = settings;
    if (has_blur) wanted.samples = 1;
    const Job measuring = has_blur ? job.subrange(0.0, 0.5) : job;
    std::optional<RequestedFrame> measured =
        render_requested(renderer, scene, camera, view.film, wanted, measuring.stop,
                         measuring.progress, Measured::airlight_and_picture);
    if (!measured || !has_blur) return measured;
    found = std::move(*measured);
    found.settings.samples = settings.samples;
  } else if (is_auto) {
    const std::optional<Settings> choice =
        choose_settings(renderer, scene, camera, view.film, settings, job.stop,
                        job.subrange(0.0, 0.5).progress, effort);
    if (!choice) return std::nullopt;
    found.settings = *choice;
  }
  // Known here, so that layers have it too.
  Settings pictured = found.settings;
  if (has_blur) pictured.samples = 1;
  const std::optional<Settings> bright =
      with_brightness(renderer, scene, camera, view.film, pictured, {job.stop, {}});
  if (!bright) return std::nullopt;
  found.settings.brightness = bright->brightness;
  const Job rendering = is_auto ? job.subrange(0.5, 1.0) : job;
  std::optional<Frame> frame = denoise == Denoising::solved
                                   ? render_denoised(renderer, view, found.settings, rendering)
                                   : render_exposure(renderer, view, found.settings, rendering);
  if (!frame) return std::nullopt;
  found.frame = std::move(*frame);
  return found;
}

std::string interval_text(const ErrorEstimate& error) {
  std::ostringstream text;
  text << error.rel_rmse << ", " << error.low << " to " << error.high;
  return text.str();
}

// Says of the airlight, which finer settings might mend, that it is not certain to meet the bound,
// or else of the rest of the picture that it is sure to miss it.
std::optional<std::string> unsure_text(const FrameError& error, const RenderRequest& request) {
  const double max_error = request.max_error;
  std::ostringstream text;
  if (error.airlight.high > max_error) {
    text << "the setting that was found is not certain to meet a max_error of " << max_error
         << ": it has a relative RMSE of " << interval_text(error.airlight);
    return text.str();
  }
  // Light scattered once, where it is asked for, is not all of it.
  const bool has_all = request.scattering == Scattering::multiple;
  if (!has_all || !error.picture || error.picture->low <= max_error) return std::nullopt;
  text << "the picture misses a max_error of " << max_error
       << ", although its airlight does not: it has a relative RMSE of "
       << interval_text(*error.picture);
  return text.str();
}

}  // namespace

struct SceneRenderer::Impl {
  struct Chosen {
    std::unique_ptr<FrameRenderer> renderer;
    std::string problem;  // why it is not what was asked for
  };
  Chosen& by(Backend backend) {
    Chosen& chosen = renderers[static_cast<std::size_t>(backend)];
    if (!chosen.renderer) {
      chosen.renderer = make_renderer(backend, transfers, chosen.problem);
    }
    return chosen;
  }

  // The scene without groups, if it has some that do the same at all times: what is prepared of its
  // medium then lasts from frame to frame.
  std::optional<Scene> without_constant_groups(const Scene& animation);

  std::shared_ptr<TransferStore> transfers = std::make_shared<TransferStore>();
  std::array<Chosen, 3> renderers;  // by Backend
  // The result of the last groups for the last medium.
  Revision grouped_medium = 0;
  std::vector<Group> groups;
  Medium medium;
};

std::optional<Scene> SceneRenderer::Impl::without_constant_groups(const Scene& animation) {
  if (animation.groups.empty() || !has_constant_groups(animation)) return std::nullopt;
  Scene ungrouped = animation;
  if (grouped_medium != animation.medium.revision() || groups != animation.groups) {
    apply_groups(ungrouped);
    grouped_medium = animation.medium.revision();
    groups = animation.groups;
    medium = ungrouped.medium;
  }
  ungrouped.groups.clear();
  ungrouped.medium = medium;
  return ungrouped;
}

// An animation without what never changes, and the scene that it shows at a time.
struct SceneRenderer::Moment {
  Moment(Impl& impl, const Scene& asked, double time)
      : ungrouped(impl.without_constant_groups(asked)),
        animation(ungrouped ? *ungrouped : asked),
        evaluated(is_evaluated(animation, time) ? std::nullopt
                                                : std::optional(evaluate_at(animation, time))),
        scene(evaluated ? *evaluated : animation) {}
  Moment(const Moment&) = delete;
  Moment& operator=(const Moment&) = delete;

  std::optional<Scene> ungrouped;
  const Scene& animation;
  std::optional<Scene> evaluated;
  const Scene& scene;
};

SceneRenderer::SceneRenderer() : impl_(std::make_unique<Impl>()) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

std::optional<Frame> SceneRenderer::render(const Scene& asked, const RenderRequest& request,
                                           const std::stop_token& stop,
                                           const std::function<void(double)>& progress) {
  brume::check(asked);
  brume::check(request);
  const Job job{stop, progress};
  const Moment moment(*impl_, asked, request.time);
  const Scene& animation = moment.animation;
  const Scene& scene = moment.scene;
  const Settings settings = settings_of(request);
  const auto scene_at = [&](double time) {
    return time == scene.time ? scene : evaluate_at(animation, time);
  };
  const ExposedView view{scene_at, scene.time, request.camera,
                         request.film.value_or(animation.film), exposure_of(animation, request)};
  check_layer_memory(scene, view.film, request.layers);
  std::vector<std::string> warnings;
  std::chrono::duration<double, std::milli> transferring{};
  if (const auto needed = needed_transfers(scene, settings); !needed.empty()) {
    const auto start = std::chrono::steady_clock::now();
    impl_->transfers->make(needed, cache_folder(), job.subrange(0.0, 0.1), &warnings);
    transferring = std::chrono::steady_clock::now() - start;
  }
  if (stop.stop_requested()) return std::nullopt;
  const auto& [renderer, problem] = impl_->by(request.backend);
  const ErrorMeasurement effort = effort_of(request);
  std::optional<RequestedFrame> found = render_view(
      *renderer, scene, view, settings, request.denoise, effort, job.subrange(0.1, 0.8));
  if (!found) return std::nullopt;

  Frame frame = std::move(found->frame);
  std::optional<FrameError> error = found->error;
  RenderRequest made = chosen(request, found->settings);
  made.film = view.film;
  frame.request = std::make_shared<const RenderRequest>(std::move(made));
  FrameStatistics& statistics = frame.statistics;
  statistics.airlight = airlight_name(found->settings);
  if (request.denoise != Denoising::none) statistics.airlight += "+denoised";
  statistics.transfer_milliseconds = transferring.count();
  if (request.backend == Backend::gl && statistics.backend != "gl") {
    const bool is_device = problem.empty() && !statistics.on_cpu.empty();
    warnings.push_back("backend gl: rendered on the CPU: " +
                       (is_device ? statistics.on_cpu.front().why : problem));
  }
  const auto rendered = std::chrono::steady_clock::now();
  if (has_more_layers(request.layers)) {
    const LayeredFrame layered{animation,
                               scene,
                               request.camera ? &*request.camera : nullptr,
                               found->settings,
                               render_lit_by(*renderer, view),
                               frame};
    std::optional<ImageLayers> layers =
        render_layers(layered, request.layers, job.subrange(0.8, 0.9));
    if (!layers) return std::nullopt;
    frame.layers = std::move(*layers);
  }
  if (!error && effort != ErrorMeasurement::none) {
    const Camera& camera = request.camera ? *request.camera : scene.camera;
    const Job measuring = job.subrange(0.9, 1.0);
    error = effort == ErrorMeasurement::full
                ? measure_error(scene, camera, frame, stop, measuring.progress,
                                Measured::airlight_and_picture)
                : measure_error_quickly(scene, camera, frame, found->settings,
                                        request.airlight == AirlightMethod::auto_, stop,
                                        measuring.progress, Measured::airlight_and_picture);
    if (!error) return std::nullopt;
  }
  if (error) {
    frame.error = error->airlight;
    frame.picture_error = error->picture;
  }
  const std::chrono::duration<double, std::milli> extra =
      std::chrono::steady_clock::now() - rendered;
  frame.statistics.extra_milliseconds = extra.count();
  if (request.airlight == AirlightMethod::auto_ && error) {
    if (auto text = unsure_text(*error, request)) {
      warnings.push_back(std::move(*text));
    }
  }
  if (const std::optional<std::string> deep = deep_fog_text(scene)) warnings.push_back(*deep);
  frame.warnings = std::move(warnings);
  if (progress) progress(1.0);
  return frame;
}

std::optional<RenderRequest> SceneRenderer::choose(const Scene& scene, const RenderRequest& request,
                                                   const std::stop_token& stop,
                                                   const std::function<void(double)>& progress) {
  brume::check(scene);
  brume::check(request);
  RenderRequest result = request;
  if (request.airlight != AirlightMethod::auto_) return result;
  const Moment moment(*impl_, scene, request.time);
  const Settings settings = settings_of(request);
  const std::optional<Settings> choice = choose_settings(
      *impl_->by(request.backend).renderer, moment.scene,
      request.camera ? *request.camera : moment.scene.camera,
      request.film.value_or(moment.animation.film), settings, stop, progress, effort_of(request));
  if (!choice) return std::nullopt;
  result.airlight = choice->airlight;
  result.slices = choice->slices;
  result.airlight_scale = choice->airlight_scale;
  return result;
}

std::optional<DeepFileStatistics> SceneRenderer::write_deep(
    const std::filesystem::path& file, const Scene& scene, const Frame& frame,
    const FrameInfo& info, const std::stop_token& stop,
    const std::function<void(double)>& progress) {
  assert(frame.request && frame.request->deep_error);
  const Job job{stop, progress};
  const Moment moment(*impl_, scene, frame.time);
  const std::optional<DeepSettings> deep = deep_settings(
      *impl_->by(frame.request->backend).renderer, moment.scene, frame.camera, frame.film,
      settings_of(*frame.request), *frame.request->deep_error, job.subrange(0.0, 0.1));
  if (!deep) return std::nullopt;
  return write_deep_frame(file, moment.scene, frame, info, *deep, *impl_->transfers,
                          job.subrange(0.1, 1.0));
}

std::optional<Frame> render(const Scene& scene, const RenderRequest& request,
                            const std::stop_token& stop,
                            const std::function<void(double)>& progress) {
  return SceneRenderer().render(scene, request, stop, progress);
}

}  // namespace brume
