#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "brume/scene.h"
#include "render/frame_renderer.h"

namespace brume {

// The scenes that speed claims are measured on.

// A scene of resources/scenes.
std::filesystem::path sample_scene_file(const std::string& name);

// A sample scene of resources/scenes, without its surfaces: the airlight alone.
Scene sample_airlight(const char* name);

// Two thick overlapping Gaussians, one light.
Scene two_gaussians();

// A ball of random Gaussians with maximum optical depth `depth`, lit by a point light.
Scene cloud(int count, double depth, std::uint64_t seed = 1, double radius = 0.3);

// A medium of these Gaussians, scaled to a maximum optical depth of `depth`.
Medium with_depth(std::span<const Gaussian> gaussians, double depth);

// n Gaussians in a unit box with the same optical depth through it for every n: radii shrink so
// that a ray always meets about the same number of them.
Medium box_of(int count);

// Small Gaussians, of radii from 0.01 to 0.05, that fill a box of 4 x 2 x 4 to an optical depth of
// 2 along the view.
Scene fog_bank(int count);

// That box before a camera, with `lights` lights around it.
Scene box_scene(int count, int lights);

// Skies: the same everywhere; brighter above; that with a sun; one with a sun near the horizon; and
// one without any edge, brighter above, of three colours.
std::shared_ptr<const RadianceMap> uniform_sky();
std::shared_ptr<const RadianceMap> gradient_sky();
std::shared_ptr<const RadianceMap> sunny_sky();
std::shared_ptr<const RadianceMap> low_sun_sky();
std::shared_ptr<const RadianceMap> smooth_sky();

// `sliced` with the airlight at every fourth pixel and the fewest slices that keep an error of 2%
// on the scene's own film, by the upper end of the interval of 1000 pixels; the most where none
// does.
Settings fewest_slices(FrameRenderer& renderer, const Scene& scene);

// CPU seconds that this process has used so far, all threads together.
double cpu_seconds();

}  // namespace brume
