#pragma once

#include <functional>

#include "render/error_estimate.h"
#include "render/frame_renderer.h"

namespace brume {

// `auto`: the cheapest settings that keep a relative RMSE of the airlight, chosen by measuring on
// the scene itself.

// The settings it chooses among, from cheap to costly. `settings` gives all that auto does not
// choose (threads, tolerance).
std::vector<Settings> quality_ladder(const Settings& settings);

// Tries settings from cheap to costly on a small frame of the view until one keeps `max_error`
// with the upper end of its interval; the last one tried if none does. `settings` as above. nullopt
// if `stop` was requested. `progress`, here and below, as of FrameRenderer.
std::optional<Settings> choose_settings(FrameRenderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, double max_error,
                                        std::stop_token stop = {},
                                        const std::function<void(double)>& progress = {});

// A frame with the settings that made it and its measured error.
struct MeasuredFrame {
  Frame frame;
  Settings settings;
  ErrorEstimate error;
};

// A sample of a view to measure its frames' error on; how many pixels depends on the number of
// Gaussians, so that it takes seconds at most. nullopt if `stop` was requested.
std::optional<ErrorSample> take_error_sample(const Scene& scene, const Camera& camera,
                                             const Frame& guide, std::uint64_t seed,
                                             std::stop_token stop = {},
                                             const std::function<void(double)>& progress = {});

// The error of a frame of a view, on a sample of its own.
std::optional<ErrorEstimate> measure_error(const Scene& scene, const Camera& camera,
                                           const Frame& frame, std::stop_token stop = {},
                                           const std::function<void(double)>& progress = {});

// Chooses settings, renders with them and measures the frame; if its own pixels break the bound,
// goes on with better settings until they hold it or there are none.
std::optional<MeasuredFrame> render_auto(FrameRenderer& renderer, const Scene& scene,
                                         const Camera& camera, const Film& film,
                                         const Settings& settings, double max_error,
                                         std::stop_token stop = {},
                                         const std::function<void(double)>& progress = {});

}  // namespace brume
