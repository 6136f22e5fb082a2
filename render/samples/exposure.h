#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "brume/output.h"
#include "render/frame_renderer.h"
#include "render/util/job.h"

namespace brume {

// Depth of field and motion blur: a frame is the mean of frames seen from points of the lens at
// moments while the shutter is open, each with another sample of its pixels. Every one of them
// costs a whole frame, fog included; only light that is the same at all moments is computed once.

// The samples of those frames, where nothing else is asked for: enough for blurs of 15 pixels.
// Wider ones show copies of bright points.
inline constexpr int blur_samples = 64;

// One of them.
struct ExposureSample {
  glm::dvec2 pixel{0.0};  // from the center [pixels]; see pixel_samples()
  glm::dvec2 lens{0.0};   // in the unit disk
  double time = 0.5;      // 0: the shutter opens, 1: it closes
};
// The samples of all frames, each of the three evenly spread by itself and independent of the
// others.
std::vector<ExposureSample> exposure_samples(int count);

// The pinhole camera at a point of the lens, in the unit disk, and the film shifted so that it sees
// the plane in focus as the center of the lens does. That plane is perpendicular to the axis.
struct LensView {
  Camera camera;
  Film film;
};
LensView seen_through(const Camera& camera, const Film& film, const glm::dvec2& lens);

// How frames of an animation are exposed.
struct Exposure {
  std::optional<int> samples{};      // per pixel of those that need it; absent: chosen
  std::optional<Shutter> shutter{};  // absent: open at a frame's time only
  double frames_per_second = default_frame_rate;
  bool animated = false;  // whether the scene depends on time
};
// The exposure that a scene with its animation asks for.
Exposure exposure_of(const Scene& animation);

// Whether a frame is the mean of several. One sample is what the center of the lens sees at the
// frame's time.
bool is_blurred(const Exposure& exposure, const Camera& camera);
// The samples of a frame; see Settings::samples.
int samples_of(const Exposure& exposure, const Camera& camera, const Scene& scene);

// Evaluates a scene, one moment after another.
using SceneAt = std::function<Scene(double time)>;

// The view that a frame is rendered from.
struct ExposedView {
  SceneAt scene_at;
  double time = 0.0;             // [s]
  std::optional<Camera> camera;  // absent: the scene's, of each moment
  Film film;
  Exposure exposure;
};

// The mean of samples_of() it if is_blurred(), else as the renderer does it with so many. nullopt
// if stopped.
std::optional<Frame> render_exposure(FrameRenderer& renderer, const ExposedView& view,
                                     const Settings& settings, const Job& job = {});

}  // namespace brume
