#include "app/export/frame_source.h"

#include "brume/at_time.h"
#include "render/deep/deep_file.h"
#include "render/layers/frame_layers.h"
#include "render/render_plan.h"
#include "render/transfer/transfer_cache.h"

namespace brume {

FrameSource::FrameSource(std::shared_ptr<const Scene> scene, std::optional<Camera> camera,
                         const Film& film, const Settings& settings, const Exposure& exposure,
                         Backend backend)
    : scene_(std::move(scene)),
      camera_(camera),
      film_(film),
      settings_(settings),
      exposure_(exposure) {
  // So that what is prepared of the medium stays from frame to frame.
  if (!scene_->groups.empty() && has_constant_groups(*scene_)) {
    auto grouped = std::make_shared<Scene>(*scene_);
    apply_groups(*grouped);
    scene_ = std::move(grouped);
  }
  std::string problem;  // each frame says what rendered it
  renderer_ = make_renderer(backend, transfers_, problem);
}

std::optional<Frame> FrameSource::at(double time, const Job& job) {
  const auto scene_at = [&](double moment) { return evaluate_at(*scene_, moment); };
  const std::vector<TransferRequest> needed = needed_transfers(scene_at(time), settings_);
  const double first = transfers_->has(needed) ? 0.0 : 0.5;
  transfers_->make(needed, cache_folder(), job.subrange(0.0, first));
  return render_exposure(*renderer_, scene_at, time, camera_, film_, settings_, exposure_,
                         job.subrange(first, 1.0));
}

std::optional<ImageLayers> FrameSource::layers(Frame& frame, const OutputLayers& layers,
                                               const Job& job) {
  const Scene scene = evaluate_at(*scene_, frame.time);
  const Settings settings = without_auto(settings_);
  const auto scene_at = [this](double moment) { return evaluate_at(*scene_, moment); };
  return render_layers(
      {*scene_, scene, camera_ ? &*camera_ : nullptr, settings,
       render_lit_by(*renderer_, {scene_at, frame.time, camera_, film_, exposure_}), frame},
      layers, job);
}

bool FrameSource::write_deep(const std::filesystem::path& file, const Frame& frame,
                             const FrameInfo& info, const Job& job) {
  const Scene scene = evaluate_at(*scene_, frame.time);
  const DeepSettings deep = deep_settings(without_auto(settings_), DeepSettings{}.error, frame);
  return write_deep_frame(file, scene, camera_.value_or(scene.camera), film_, deep, *transfers_,
                          info, job)
      .has_value();
}

}  // namespace brume
