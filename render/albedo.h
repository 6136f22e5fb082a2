#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/job.h"

namespace brume {

// A single-scattering albedo w below 1 means extinction = scattering / w. Every airlight method
// knows media that only scatter; a medium with albedo w is one of them with densities divided by w
// (what it takes away), whose airlight is then multiplied by w (what of it is scattered). That is
// exact. Colour channels of the same albedo share the work.

struct AlbedoGroup {
  double albedo = 1.0;
  std::vector<std::size_t> channels;  // of R, G, B
};

// One to three groups that together hold every channel once.
std::vector<AlbedoGroup> albedo_groups(const glm::dvec3& albedo);

// The medium of the extinction coefficient.
Medium extinction_medium(const Medium& scattering, double albedo);

// Takes the channels of a group from `part`, a frame of its extinction_medium(), into `frame`.
void take_channels(const AlbedoGroup& group, const Frame& part, Frame& frame);

// The frame of a scene by way of `render`, which is asked for the frames of its groups: of what
// `scene` has with the group's extinction_medium(), as number `which`. nullopt where that says so.
using RenderGroup = std::function<std::optional<Frame>(const Scene& scene, std::size_t which,
                                                       double albedo, const Job& job)>;
std::optional<Frame> render_groups(const Scene& scene, const Job& job, const RenderGroup& render);

// Adds what another part of a frame cost.
void add_cost(const FrameStatistics& part, FrameStatistics& sum);

}  // namespace brume
