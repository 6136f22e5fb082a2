#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>

#include "brume/scene.h"
#include "core/scene/lights/beam_pattern.h"

namespace brume {

// Intensity of a point light by direction, relative to its intensity, at the angle t from its axis:
// of a spot light that of glTF's KHR_lights_punctual,
//   clamp((cos t - cos outer) / max(1e-9, cos inner - cos outer), 0, 1)^2,
// of a piece of an area light that of a surface of the same radiance everywhere (Lambert),
//   max(cos t, 0), or two-sided |cos t|,
// with a photometric profile that in the direction, times what the cone leaves,
// with a picture in the beam of a spot that in the direction, times what the cone leaves,
// else 1.
class LightFalloff {
 public:
  enum class Shape { isotropic, cone, cosine, two_cosines, profile, picture };

  LightFalloff() = default;  // isotropic
  // The falloff of a luminaire that hangs at azimuth 0 along +x, turned about its axis, then, of a
  // spot, the shortest way from straight down to its direction. Without a profile it is isotropic,
  // or a cone.
  explicit LightFalloff(const light::Point& point);
  explicit LightFalloff(const light::Spot& spot);
  // That of a spot with one of its beam_patterns().
  LightFalloff(const light::Spot& spot, const BeamPattern& pattern);
  // `normal`: unit.
  static LightFalloff of_surface(const glm::dvec3& normal, bool two_sided);

  [[nodiscard]] Shape shape() const { return shape_; }
  [[nodiscard]] bool is_isotropic() const { return shape_ == Shape::isotropic; }
  // Unit; 0 if isotropic.
  [[nodiscard]] const glm::dvec3& axis() const { return axis_; }
  // The directions of azimuths 0 and 90 degrees, of a cone, a profile and a picture; unit.
  [[nodiscard]] const glm::dvec3& azimuth_0() const { return azimuth_0_; }
  [[nodiscard]] const glm::dvec3& azimuth_90() const { return azimuth_90_; }
  // Of a profile or a picture; else null.
  [[nodiscard]] const std::shared_ptr<const IntensityMap>& map() const { return map_; }
  // Of a picture: 1 over the tangent of the cone's angle; else 0.
  [[nodiscard]] double cotangent() const { return cotangent_; }
  // The cone of a profile without a spot holds all directions.
  [[nodiscard]] bool has_cone() const { return shape_ == Shape::cone || map_; }
  // The falloff of a cone, and of a profile within one, is clamp((dark_versine - versine(w)) *
  // per_versine, 0, 1)^2, dark at dark_versine and full at full_versine, which is below 0 where no
  // direction gets all. The versine 1 - cos t keeps its digits near the axis, where cosines differ
  // in none that single precision has.
  [[nodiscard]] double dark_versine() const { return dark_versine_; }
  [[nodiscard]] double per_versine() const { return per_versine_; }
  [[nodiscard]] double full_versine() const { return dark_versine_ - 1.0 / per_versine_; }
  // The versine of the angle between the unit direction w and the axis.
  [[nodiscard]] double versine(const glm::dvec3& w) const;

  // In the unit direction w from the light. In [0, 1].
  [[nodiscard]] double at(const glm::dvec3& w) const;
  // The same by the map of a profile, as vectors and shaders look it up: several times as fast, and
  // off by up to 5e-3.
  [[nodiscard]] double by_map(const glm::dvec3& w) const;

  // Parameters t, ascending, at which the line origin + t w, w unit, may enter or leave what the
  // light lights at all, or fully: between two of them the falloff is smooth. NaN-free; +-inf where
  // there are fewer than four.
  [[nodiscard]] std::array<double, 4> edges(const glm::dvec3& light, const glm::dvec3& origin,
                                            const glm::dvec3& w) const;

  bool operator==(const LightFalloff&) const = default;

 private:
  void set_profile(const LightProfile& profile);  // within the cone
  void turn_about_axis(double degrees);
  [[nodiscard]] double in_cone(const glm::dvec3& w) const;

  glm::dvec3 axis_{0.0};
  double dark_versine_ = 0.0;
  double per_versine_ = 0.0;
  Shape shape_ = Shape::isotropic;
  glm::dvec3 azimuth_0_{0.0}, azimuth_90_{0.0};
  std::shared_ptr<const PhotometricProfile> profile_;
  std::shared_ptr<const IntensityMap> map_;
  double cotangent_ = 0.0;
};

}  // namespace brume
