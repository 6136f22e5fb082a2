#pragma once

#include "render/error_estimate.h"
#include "render/renderer.h"

namespace brume {

// `auto`: the cheapest settings that keep a relative RMSE of the airlight, chosen by measuring on
// the scene itself.

// Tries settings from cheap to costly on a small frame of the view until one keeps `max_error`
// with the upper end of its interval; the last one tried if none does. `settings` gives all that
// auto does not choose (threads, tolerance). nullopt if `stop` was requested.
std::optional<Settings> choose_settings(Renderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, double max_error,
                                        std::stop_token stop = {});

// The settings that auto would try after these, if there are any better.
std::optional<Settings> better_settings(const Settings& settings);

}  // namespace brume
