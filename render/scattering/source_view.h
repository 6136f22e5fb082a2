#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "brume/revision.h"
#include "core/scene/camera_rays.h"
#include "render/scattering/source_function.h"
#include "render/scattering/source_lookup.h"
#include "render/util/job.h"

namespace brume {

// The source function of an anisotropic medium at the nodes of a grid, in the directions in which
// a camera sees them: what their harmonics sum to, without narrow clusters. Look-ups then cost
// little more than in an isotropic medium, and where those directions change little from node to
// node they are as exact as the grid. Cached while the eye stays, or the direction of parallel
// rays.
class SourceView {
 public:
  // In parallel. Empty for isotropic media, which need none.
  void update(const SourceFunction& function, const CameraRays& rays, const Job& job);
  // Look-ups as of the last update(), which was not stopped. Keeps references.
  [[nodiscard]] SourceLookup lookup(const SourceFunction& function) const;

 private:
  Revision grid_ = 0;
  double scale_ = 0.0;
  glm::dvec3 eye_{0.0};
  std::optional<glm::dvec3> direction_;     // of parallel rays
  std::vector<std::vector<float>> levels_;  // R G B 0 per node
};

}  // namespace brume
