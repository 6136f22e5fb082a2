#include "core/scene/light_rules.h"

#include "core/number_domain.h"
#include "core/scene/fields/light_fields.h"

namespace brume {

std::optional<RefusedLight> refusal(const Light& light) {
  const auto* direction = find_value<glm::dvec3>(light, "direction");
  if (direction && light.keys.direction.empty() && *direction == glm::dvec3(0.0)) {
    return RefusedLight{"direction", "found a vector of length 0; allowed: any other"};
  }
  const auto* spot = light.as<light::Spot>();
  if (spot && !spot->texture.file.empty() && light.keys.outer_angle.empty() &&
      !(spot->outer_angle < 90.0)) {
    return RefusedLight{"outer_angle", "found " + quoted_text(spot->outer_angle) +
                                           "; allowed: below 90 degrees with a texture"};
  }
  const bool is_keyed = !light.keys.inner_angle.empty() || !light.keys.outer_angle.empty();
  if (!spot || is_keyed) return std::nullopt;
  if (!(spot->outer_angle > 0.0)) {
    return RefusedLight{"outer_angle", "found 0; allowed: above 0 degrees"};
  }
  if (!(spot->inner_angle <= spot->outer_angle)) {
    return RefusedLight{"inner_angle", "found " + quoted_text(spot->inner_angle) +
                                           "; allowed: at most outer_angle, which is " +
                                           quoted_text(spot->outer_angle)};
  }
  return std::nullopt;
}

}  // namespace brume
