#pragma once

#include <functional>
#include <optional>

#include "brume/frame.h"
#include "render/settings.h"
#include "render/util/job.h"

namespace brume {

// The mean of `count` frames of one film: all layers but the depth, which is that of `center`, a
// frame of pixels' centers, as is airlight_at_centers. Statistics are added up. nullopt if
// render(k), one after another, is.
using RenderNth = std::function<std::optional<Frame>(int k, const Job& job)>;
std::optional<Frame> mean_frame(Frame center, int count, const Job& job, const RenderNth& render);

// settings.samples samples of every pixel, as whole frames of shifted films: the plain method,
// which pays for all that a frame costs as many times. `path` divides its paths among them; it may
// take fewer samples then.
using RenderFilm =
    std::function<std::optional<Frame>(const Film& film, const Settings& settings, const Job& job)>;
std::optional<Frame> render_shifted(const Film& film, const Settings& settings, const Job& job,
                                    const RenderFilm& render);

// The samples that settings ask for, or for `path` as many as its paths allow.
int samples_of_paths(const Settings& settings);

// `path`: the settings of one of `count` frames that share the paths of a pixel.
Settings share_of_paths(const Settings& settings, int k, int count);

}  // namespace brume
