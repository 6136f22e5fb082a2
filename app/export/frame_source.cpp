#include "app/export/frame_source.h"

#include "core/scene/at_time.h"
#include "render/render_plan.h"
#include "render/transfer/transfer_cache.h"

namespace brume {

FrameSource::FrameSource(std::shared_ptr<const Scene> scene, std::optional<Camera> camera,
                         const Film& film, const Settings& settings, Backend backend)
    : scene_(std::move(scene)), camera_(camera), film_(film), settings_(settings) {
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
  const Scene scene = evaluate_at(*scene_, time);
  const std::vector<TransferRequest> needed = needed_transfers(scene, settings_);
  const double first = transfers_->has(needed) ? 0.0 : 0.5;
  transfers_->make(needed, cache_folder(), job.subrange(0.0, first));
  return renderer_->render(scene, camera_.value_or(scene.camera), film_, settings_, job.stop,
                           job.subrange(first, 1.0).progress);
}

}  // namespace brume
