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

FrameMaker::FrameMaker(const RenderOptions& options, Scene animation)
    : options_(options),
      animation_(std::move(animation)),
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
  RequestedFrame found = finished(render_shot(*renderer_, shot(), settings_, line.job()));
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

FrameInfo FrameMaker::info_of(const RequestedFrame& found, const std::string& fingerprint) const {
  return {.scene = options_.scene_file(),
          .airlight = airlight_name(found.settings),
          .backend = found.frame.statistics.backend,
          .look = look_,
          .bits = options_.bits(),
          .noise = relative_noise(found.frame),
          .fingerprint = fingerprint};
}

FrameMaker::Content FrameMaker::content(RequestedFrame found,
                                        const std::string& fingerprint) const {
  Content content{{}, info_of(found, fingerprint), {}};
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
    content.layers = finished(render_layers(layered, layers, line.job()));
  }
  content.frame = std::move(found.frame);
  return content;
}

DeepFileStatistics FrameMaker::write_deep(const std::filesystem::path& file,
                                          const RequestedFrame& found,
                                          const std::string& fingerprint) const {
  const ProgressLine line("deep frame");
  DeepFileStatistics deep =
      finished(write_deep_frame(file, *scene_, scene_->camera, film_,
                                deep_settings(found.settings, options_.deep_error(), found.frame),
                                *transfers_, info_of(found, fingerprint), line.job()));
  if (deep.image.coarse_tiles > 0) {
    print_warnings({"--deep-error: " + std::to_string(deep.image.coarse_tiles) +
                    " tiles of 16 x 8 pixels are too steep for this error; more --slices help"});
  }
  return deep;
}

}  // namespace brume
