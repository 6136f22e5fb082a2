#pragma once

#include <array>
#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "core/scene/camera_rays.h"
#include "render/scattering/lobe/lobe_columns.h"
#include "render/scattering/lobe/seen_surfels.h"
#include "render/scattering/lobe/sky_lobe.h"
#include "render/scattering/lobe/view_depths.h"
#include "render/scattering/source_grid.h"
#include "render/util/job.h"

namespace brume {

// The part of the source function that a SourceGrid's bands do not hold of the light of surfaces,
// and of the sky that is seen between them: what the forward lobe of the phase function scatters to
// the eye. It changes within few degrees of the view ray, so it is tabulated by film position and
// distance.
class EyeLobe {
 public:
  EyeLobe() = default;  // nothing
  // Works in parallel. The result is invalid after the job was stopped.
  EyeLobe(const SourceGrid& grid, const SentLight& sent, const LobedSky& sky,
          const LobedMedium& medium, const CameraRays& rays, const Job& job);

  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] Revision revision() const { return revision_; }
  // Its J at distance t of a ray from the eye, or `offset` from there, in the unit direction w.
  [[nodiscard]] glm::vec3 at(const glm::vec3& offset, const glm::vec3& w, float t) const;

  // The table, x fastest, R G B and the distance of a surface, behind which another table follows
  // [u]; and where a place is in both: per axis x and y the dot product of
  // (offset + w / (w . forward), 1) and `film`, along z scaled by `distance`.
  static constexpr glm::ivec3 size = LobeColumns::size;
  struct Places {
    std::array<glm::vec4, 2> film{};
    glm::vec3 forward{0.0f};
    float start = 0.0f;     // of z [u]
    float distance = 1.0f;  // from there, at which z is in the middle [u]
  };
  [[nodiscard]] std::span<const glm::vec4> values() const { return values_; }
  [[nodiscard]] const Places& places() const { return places_; }

 private:
  // Adds the light of the sky, which a surface's edge parts: before it is what the eye sees there,
  // behind it what passes by.
  void add_places_behind(const LobeColumns& columns, const std::vector<glm::vec4>& sky);

  Revision revision_ = 0;
  Places places_;
  std::vector<glm::vec4> values_;
};

}  // namespace brume
