#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/lights/point_lights.h"
#include "render/simd/surface_points.h"

namespace brume {

// SIMD kernels of area lights at surfaces (Highway, single precision).

// An area light as points see it, relative to their origin.
struct AreaShape {
  std::vector<glm::vec3> corners{};  // see AreaOutline; none of a sphere
  glm::vec3 center{0.0f};
  float radius = 0.0f;  // of a sphere
  bool is_two_sided = false;
  // Squared: from here on its points are as good, and the angles between its edges lose their
  // digits.
  float far2 = 0.0f;

  AreaShape(const AreaLight& area, const glm::dvec3& area_center, const glm::dvec3& origin);
};

// What the points send that stand for an area light together. Next to the light they would show;
// so their sum is brought to the irradiance of the whole, and what hides some of them counts as it
// does among them.
class AreaSum {
 public:
  void clear();
  // Adds the irradiance of one, which stands for so much area, if no surface were in the way.
  void add(const SurfacePoints& points, const LightAtPoints& light, float area);
  // How much of the light the medium lets through to point k.
  [[nodiscard]] float transmittance(std::size_t k) const {
    return irradiance_[k] > 0.0f ? attenuated_[k] / irradiance_[k] : 0.0f;
  }
  // whole += what the points send, brought to area_irradiance(), of which this is the fast form.
  void add_to(const SurfacePoints& points, const AreaShape& area, PointRadiance& whole) const;

  PointRadiance radiance;  // that the points have sent

 private:
  PointArray irradiance_;  // without the medium, per radiance [sr]
  PointArray attenuated_;
};

}  // namespace brume
