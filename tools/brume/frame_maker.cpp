#include "tools/brume/frame_maker.h"

#include <chrono>
#include <utility>
#include <vector>

#include "brume/at_time.h"
#include "brume/limits.h"
#include "render/gl_renderer.h"
#include "render/layers/frame_layers.h"
#include "render/render_plan.h"
#include "render/transfer/transfer_cache.h"
#include "tools/brume/command.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

void check_layer_memory(const Scene& scene, const Film& film, const OutputLayers& layers) {
  const std::size_t bytes = layer_bytes(scene, film, layers);
  if (bytes <= limits::scene_bytes) return;
  throw UsageError("--layers: they take " + std::to_string(bytes) + " bytes; allowed: at most " +
                   std::to_string(limits::scene_bytes) + "; choose fewer, or a smaller --size");
}

}  // namespace

FrameMaker::FrameMaker(const RenderOptions& options, Scene scene)
    : options_(options),
      animation_(options.adjusted(std::move(scene))),
      settings_(options.settings()),
      look_(options.display()),
      exposure_(options.exposure(animation_)),
      film_(options.film(animation_)),
      renderer_(make_renderer(options.backend(), transfers_, problem_)) {
  if (look_.view) print_warnings(look_.view->warnings());
}

void FrameMaker::go_to(double time) {
  scene_ = evaluate_at(animation_, time);
  check_layer_memory(*scene_, film_, options_.layers());
  if (settings_.airlight == AirlightMethod::path) return;
  const Clock::time_point start = Clock::now();
  const std::vector<TransferRequest> needed = needed_transfers(*scene_, settings_);
  if (needed.empty()) return;
  std::vector<std::string> warnings;
  {
    const ProgressLine line("radiance transfer");
    transfers_->make(needed, cache_folder(), line.job(), &warnings);
    check_interrupted();
  }
  print_warnings(warnings);
  transfer_milliseconds_ += Milliseconds(Clock::now() - start).count();
}

Shot FrameMaker::shot() const {
  return {animation_, *scene_, std::nullopt, film_, exposure_};
}

RequestedFrame FrameMaker::render(const std::string& label) const {
  const ProgressLine line(label);
  Settings settings = settings_;
  if (settings.airlight == AirlightMethod::auto_ && !options_.auto_measures()) {
    settings = finished(choose_settings(*renderer_, *scene_, scene_->camera, film_, settings,
                                        interruption(), line.progress()));
  }
  RequestedFrame found = finished(render_shot(*renderer_, shot(), settings, line.job()));
  warn_of_cpu(found.frame.statistics);
  return found;
}

RequestedFrame FrameMaker::render(const std::string& label, const Settings& settings,
                                  const Camera& camera) const {
  Shot moved = shot();
  moved.camera = camera;
  const ProgressLine line(label);
  return finished(render_shot(*renderer_, moved, settings, line.job()));
}

// Reports, once, when gl was requested but did not render.
void FrameMaker::warn_of_cpu(const FrameStatistics& statistics) const {
  if (options_.backend() != Backend::gl || statistics.backend == "gl" || has_warned_) return;
  has_warned_ = true;
  std::string problem = problem_;
  if (problem.empty() && !statistics.on_cpu.empty()) problem = statistics.on_cpu.front().why;
  print_warnings({"--backend gl: rendered on the CPU: " + problem});
}

ImageLayers FrameMaker::complete(RequestedFrame& found) const {
  ImageLayers more;
  if (const OutputLayers layers = options_.layers(); has_more_layers(layers)) {
    const Shot seen = shot();
    const LayeredFrame layered{
        animation_,
        *scene_,
        nullptr,
        found.settings,
        render_lit_by(*renderer_, {seen.moments(), scene_->time, seen.camera, film_, exposure_}),
        found.frame};
    const ProgressLine line("layers");
    more = finished(render_layers(layered, layers, line.job()));
  }
  // What paths say of their error is their noise; the reference is what errors are measured by.
  const AirlightMethod method = found.settings.airlight;
  if (options_.measures_error() && !found.error && method != AirlightMethod::path &&
      method != AirlightMethod::reference) {
    const ProgressLine line("measuring the error");
    found.error = finished(
        measure_error(*scene_, scene_->camera, found.frame, interruption(), line.progress()));
  }
  return more;
}

FrameInfo FrameMaker::info(const RequestedFrame& found) const {
  return {.scene = options_.scene_file(),
          .airlight = airlight_name(found.settings),
          .backend = found.frame.statistics.backend,
          .look = look_,
          .bits = options_.bits(),
          .noise = relative_noise(found.frame),
          .settings = settings_metadata(found.settings),
          .error = found.error};
}

DeepFileStatistics FrameMaker::write_deep(const std::filesystem::path& file,
                                          const RequestedFrame& found,
                                          const FrameInfo& info) const {
  const ProgressLine line("deep frame");
  DeepFileStatistics deep =
      finished(write_deep_frame(file, *scene_, scene_->camera, film_,
                                deep_settings(found.settings, options_.deep_error(), found.frame),
                                *transfers_, info, line.job()));
  if (deep.image.coarse_tiles > 0) {
    print_warnings({"--deep-error: " + std::to_string(deep.image.coarse_tiles) +
                    " tiles of 16 x 8 pixels are too steep for this error; more --slices help"});
  }
  return deep;
}

}  // namespace brume
