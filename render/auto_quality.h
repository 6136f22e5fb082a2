#pragma once

#include <functional>

#include "render/frame_errors.h"
#include "render/frame_renderer.h"

namespace brume {

// `auto`: the cheapest settings that keep a relative RMSE of the airlight, chosen by measuring on
// the scene itself.

// Of the pixels that frames are judged by. Settings are chosen by others: what was chosen to do
// well on some must not be judged by the same ones.
inline constexpr std::uint64_t seed_of_judgement = 2;

// The settings it chooses among, from cheap to costly. `settings` gives all that auto does not
// choose (threads, tolerance).
std::vector<Settings> quality_ladder(const Settings& settings);

// Tries settings from cheap to costly on a small frame of the view until one is likely to keep
// `max_error`; if none is, the cheapest of those with about the least error. `settings` as above.
// nullopt if `stop` was requested. `progress`, here and below, as of FrameRenderer.
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

// The error of a frame of a view, on a sample of its own.
std::optional<ErrorEstimate> measure_error(const Scene& scene, const Camera& camera,
                                           const Frame& frame, std::stop_token stop = {},
                                           const std::function<void(double)>& progress = {});

// Chooses settings, renders with them and measures the frame; if its own pixels break the bound,
// goes on with better settings until they hold it or there are none. Then it is the cheapest frame
// that may keep the bound after all, if one may, or the last.
std::optional<MeasuredFrame> render_auto(FrameRenderer& renderer, const Scene& scene,
                                         const Camera& camera, const Film& film,
                                         const Settings& settings, double max_error,
                                         std::stop_token stop = {},
                                         const std::function<void(double)>& progress = {});

}  // namespace brume
