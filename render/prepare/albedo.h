#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brume/frame.h"
#include "brume/revision.h"
#include "brume/scene.h"
#include "render/util/job.h"

namespace brume {

// Single-scattering albedo w: extinction = scattering / w. The airlight methods handle scattering
// media only; a medium of albedo w is rendered as one with densities divided by w, whose airlight
// is then multiplied by w. This is exact. Gaussians with an albedo of their own have their
// densities divided by that, and scatter as much as it is more or less than w; those that shine do
// so by as much more as the airlight is then multiplied by. Channels that are the same are rendered
// together.

struct AlbedoGroup {
  double albedo = 1.0;                  // of the medium, but for Gaussians with their own
  std::vector<std::size_t> channels{};  // of R, G, B
  bool has_own_optics = false;          // Gaussians with an albedo of their own, or that shine

  bool operator==(const AlbedoGroup&) const = default;
};

// The mean over a group's channels, as weights of R, G, B.
glm::dvec3 channel_weights(const AlbedoGroup& group);

// Groups the channels R, G, B by albedo, the medium's and, unless they are left out, its
// Gaussians': one to three groups. Where panes are colored each channel is one: surfaces let
// through as much of all light in a group.
std::vector<AlbedoGroup> albedo_groups(const Scene& scene, bool with_own_optics = true);

// Densities divided by the albedos of a group: the extinction coefficient. The optics of its
// Gaussians are relative_optics(): a grey albedo, and an emission whose channels are the group's.
Medium extinction_medium(const Scene& scene, const AlbedoGroup& group);

// The extinction media of a renderer's groups, cached: each keeps its revision while the scattering
// medium and the albedo do.
class ExtinctionMedia {
 public:
  // Valid until the next call for this group.
  const Medium& update(std::size_t which, const Scene& scene, const AlbedoGroup& group);

 private:
  struct Entry {
    Revision scattering = 0;
    AlbedoGroup group;
    Medium medium;
  };
  std::vector<Entry> entries_;  // by group
};

// Copies the channels of a group from its frame, rendered in extinction_medium(), to `frame`.
void copy_channels(const AlbedoGroup& group, const Frame& group_frame, Frame& frame);

// Renders one frame per albedo group and combines them. `render` gets the scene with the group's
// extinction_medium(), the index of the group and itself; nullopt from it ends the frame. `groups`:
// of the scene.
using RenderGroup = std::function<std::optional<Frame>(const Scene& scene, std::size_t which,
                                                       const AlbedoGroup& group, const Job& job)>;
std::optional<Frame> render_groups(const Scene& scene, std::span<const AlbedoGroup> groups,
                                   ExtinctionMedia& media, const Job& job,
                                   const RenderGroup& render);

// Adds the costs of a group's frame to the total.
void add_cost(const FrameStatistics& group_frame, FrameStatistics& sum);

}  // namespace brume
