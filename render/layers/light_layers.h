#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "core/io/image/image_file.h"
#include "render/settings.h"
#include "render/util/job.h"

namespace brume {

// Frames under one source of light at a time: each light that is on, the environment, and what
// emits. Light transport is linear, so these add up to the picture.

// The names of layers: a light's name, or "light_3" of one without, letters, digits and
// _ only; names that several have, or that mean another layer, are numbered. In the order of
// Scene::lights; empty for lights that are off or black.
std::vector<std::string> light_layer_names(const std::vector<Light>& lights);

// Renders the frame again, of the scene as `light` changes it, with other settings. nullopt if
// stopped.
using ChangeLight = std::function<void(Scene& scene)>;
using RenderLit = std::function<std::optional<Frame>(const ChangeLight& light,
                                                     const Settings& settings, const Job& job)>;

// Adds of `layers`, as far as they are on and the scene has them:
//   lights       airlight.NAME.R/G/B and surface.NAME.R/G/B of each light
//   environment  airlight.environment, surface.environment and background, the environment as it is
//                seen, all through the fog
//   emission     airlight.emission and surface.emission
//   direct       airlight.direct and surface.direct: light scattered once at most
//   multiple     airlight.multiple and surface.multiple: the rest of the picture
//   reflection   reflection: the part that smooth surfaces mirror, but of lights that their
//                highlights show, through the fog; black where nothing mirrors
// With any of the first three all of them are rendered, and the picture and its airlight become
// their sum. Every frame has the same slices, light tables and shadow maps, and each pixel of its
// own: settings.airlight_scale does not count. False if stopped.
bool add_light_layers(const RenderLit& render_lit, const Scene& scene, const Settings& settings,
                      const OutputLayers& layers, const Job& job, Frame& frame, ImageLayers& image);

// How many frames that takes.
std::size_t light_layer_frames(const Scene& scene, const Settings& settings,
                               const OutputLayers& layers);

}  // namespace brume
