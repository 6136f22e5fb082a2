#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "brume/keys.h"
#include "core/number_domain.h"

namespace brume {

// The nearest value of a domain.
inline double nearest(const NumberDomain& domain, double value) {
  return domain.nearest(value);
}
inline glm::dvec2 nearest(const NumberDomain& domain, const glm::dvec2& v) {
  return {domain.nearest(v.x), domain.nearest(v.y)};
}
inline glm::dvec3 nearest(const NumberDomain& domain, const glm::dvec3& v) {
  return {domain.nearest(v.x), domain.nearest(v.y), domain.nearest(v.z)};
}
inline glm::dquat nearest(const NumberDomain&, const glm::dquat& rotation) {
  return rotation;
}
// The value of keys; in the domain also where tangents lead outside.
template <class T>
T value_at(const Keys<T>& keys, double time, const NumberDomain& domain) {
  return nearest(domain, value_at(keys, time));
}

}  // namespace brume
