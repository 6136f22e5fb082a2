#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/revision.h"
#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/util/job.h"

namespace brume {

// Single-scattering albedo w: extinction = scattering / w. The airlight methods handle scattering
// media only; a medium of albedo w is rendered as one with densities divided by w, whose airlight
// is then multiplied by w. This is exact. Channels of equal albedo are rendered together.

struct AlbedoGroup {
  double albedo = 1.0;
  std::vector<std::size_t> channels;  // of R, G, B
};

// Groups the channels R, G, B by albedo: one to three groups.
std::vector<AlbedoGroup> albedo_groups(const glm::dvec3& albedo);

// Densities divided by the albedo: the extinction coefficient.
Medium extinction_medium(const Medium& scattering, double albedo);

// The extinction media of a renderer's groups, cached: each keeps its revision while the scattering
// medium and the albedo do.
class ExtinctionMedia {
 public:
  // Valid until the next call for this group.
  const Medium& update(std::size_t group, const Medium& scattering, double albedo);

 private:
  struct Entry {
    Revision scattering = 0;
    double albedo = 1.0;
    Medium medium;
  };
  std::vector<Entry> entries_;  // by group
};

// Copies the channels of a group from its frame, rendered in extinction_medium(), to `frame`.
void copy_channels(const AlbedoGroup& group, const Frame& group_frame, Frame& frame);

// Renders one frame per albedo group and combines them. `render` gets the scene with the group's
// extinction_medium(), the index of the group and its albedo; nullopt from it ends the frame.
using RenderGroup = std::function<std::optional<Frame>(const Scene& scene, std::size_t which,
                                                       double albedo, const Job& job)>;
std::optional<Frame> render_groups(const Scene& scene, ExtinctionMedia& media, const Job& job,
                                   const RenderGroup& render);

// Adds the costs of a group's frame to the total.
void add_cost(const FrameStatistics& group_frame, FrameStatistics& sum);

}  // namespace brume
