#pragma once

#include <functional>

#include "brume/render.h"
#include "render/frame_renderer.h"
#include "render/quality/frame_errors.h"
#include "render/settings.h"

namespace brume {

// `auto`: chooses the cheapest settings whose airlight meets a relative RMSE, measured on the scene
// itself.

// Random seed of the pixels that evaluate a frame. Settings are chosen on other pixels, to keep the
// estimate unbiased.
inline constexpr std::uint64_t evaluation_seed = 2;

// The candidate settings in order of cost. `settings` provides everything that auto does not choose
// (threads, tolerances).
std::vector<Settings> quality_ladder(const Settings& settings);

// Tries the candidates on a small frame of the whole view until one probably meets
// settings.max_error; if none does, returns the cheapest of those with about the lowest error.
// `full`: tries all of them; else on few pixels, and not those that are clearly too coarse. nullopt
// if `stop` was requested. `progress`, here and below: see FrameRenderer.
std::optional<Settings> choose_settings(FrameRenderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, const std::stop_token& stop = {},
                                        const std::function<void(double)>& progress = {},
                                        ErrorMeasurement effort = ErrorMeasurement::full);

// A frame with the settings that made it, and its error if `auto` measured it.
struct RequestedFrame {
  Frame frame;
  Settings settings;
  std::optional<FrameError> error;
};

// Estimates the error of a frame on an independent sample of its pixels, as sure as is useful.
std::optional<FrameError> measure_error(const Scene& scene, const Camera& camera,
                                        const Frame& frame, const std::stop_token& stop = {},
                                        const std::function<void(double)>& progress = {},
                                        Measured measured = Measured::airlight);

// The same for at most what a frame of the settings cost. Their max_error is the bound to decide
// about where `has_bound`.
std::optional<FrameError> measure_error_quickly(const Scene& scene, const Camera& camera,
                                                const Frame& frame, const Settings& settings,
                                                bool has_bound, const std::stop_token& stop = {},
                                                const std::function<void(double)>& progress = {},
                                                Measured measured = Measured::airlight);

// Renders with the settings; if they say `auto_`, chooses them, renders and measures. Whether they
// meet max_error is judged by the airlight of small frames of the whole view, so that regions of it
// are rendered alike: while the measured error exceeds it, continues with finer settings, which
// change little else. If none meets it, takes the cheapest that may meet it within the confidence
// interval, or else the last.
std::optional<RequestedFrame> render_requested(FrameRenderer& renderer, const Scene& scene,
                                               const Camera& camera, const Film& film,
                                               const Settings& settings,
                                               const std::stop_token& stop = {},
                                               const std::function<void(double)>& progress = {},
                                               Measured measured = Measured::airlight);

}  // namespace brume
