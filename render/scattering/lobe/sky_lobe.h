#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/scene/lights/radiance_map.h"
#include "render/scattering/lobe/view_depths.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// A sky in the frame of its maps, times `scale`.
struct LobedSky {
  RadianceMap radiance;
  // The maps of its clusters convolved with the forward lobe, see SourceFunction: the sum counts.
  std::vector<std::shared_ptr<const RadianceMap>> scattered;
  glm::dmat3 to_map{1.0};
  double scale = 0.0;
};

// The light of a sky that the forward lobe scatters beside surfaces: rays tell how much of what a
// direction is lit by is seen from a place. Keeps references.
class SkyLobe {
 public:
  SkyLobe(const LobedSky& sky, const RayCaster& ray_caster, const LobedMedium& medium,
          const ViewDepths& depths);

  [[nodiscard]] bool empty() const { return directions_.empty(); }
  // J at distance t from the beginning of a view ray in the unit direction w, attenuated on its way
  // there like the light that comes along the ray, and relative to the weights of look-ups: on its
  // way to the eye by the whole extinction. Thread-safe.
  [[nodiscard]] glm::vec3 operator()(const glm::dvec3& begin, const glm::dvec3& w, double t) const;

 private:
  // A direction around that which the lobe is around, and the lobe there over the density of
  // directions.
  struct Direction {
    glm::dvec3 w;
    float weight;
  };
  void add_directions(int count, double anisotropy);
  // J at a place without a medium.
  [[nodiscard]] glm::vec3 seen(const glm::dvec3& place, const glm::dvec3& w) const;
  // The light that the lobe scatters, as if nothing hid the sky.
  [[nodiscard]] glm::vec3 whole(const glm::dvec3& w) const;

  const LobedSky& sky_;
  const RayCaster& ray_caster_;
  const LobedMedium& medium_;
  const ViewDepths& depths_;
  std::vector<Direction> directions_;
};

}  // namespace brume
