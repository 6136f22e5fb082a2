#include "render/shot.h"

#include <utility>

#include "brume/at_time.h"
#include "render/samples/brightness.h"

namespace brume {

SceneAt Shot::moments() const {
  return [animation = &animation, scene = &scene](double time) {
    return time == scene->time ? *scene : evaluate_at(*animation, time);
  };
}

std::optional<RequestedFrame> render_shot(FrameRenderer& renderer, const Shot& shot,
                                          Settings settings, const Job& job) {
  const Camera& camera = shot.seen_by();
  settings.samples = samples_of(shot.exposure, camera, shot.scene);
  settings.brightness.reset();  // perhaps of another moment
  const bool is_auto = settings.airlight == AirlightMethod::auto_;
  RequestedFrame found{{}, settings, std::nullopt};
  if (is_auto && shot.measures_error) {
    const bool has_blur = is_blurred(shot.exposure, camera);
    Settings wanted = settings;
    if (has_blur) wanted.samples = 1;
    const Job measuring = has_blur ? job.subrange(0.0, 0.5) : job;
    std::optional<RequestedFrame> measured = render_requested(
        renderer, shot.scene, camera, shot.film, wanted, measuring.stop, measuring.progress);
    if (!measured || !has_blur) return measured;
    found = std::move(*measured);
    found.settings.samples = settings.samples;
  } else if (is_auto) {
    const std::optional<Settings> choice =
        choose_settings(renderer, shot.scene, camera, shot.film, settings, job.stop,
                        job.subrange(0.0, 0.5).progress);
    if (!choice) return std::nullopt;
    found.settings = *choice;
  }
  Settings pictured = found.settings;
  if (has_blur) pictured.samples = 1;
  const std::optional<Settings> bright =
      with_brightness(renderer, shot.scene, camera, shot.film, pictured, {job.stop, {}});
  if (!bright) return std::nullopt;
  found.settings.brightness = bright->brightness;
  std::optional<Frame> frame =
      render_exposure(renderer, shot.moments(), shot.scene.time, shot.camera, shot.film,
                      found.settings, shot.exposure, is_auto ? job.subrange(0.5, 1.0) : job);
  if (!frame) return std::nullopt;
  found.frame = std::move(*frame);
  return found;
}

}  // namespace brume
