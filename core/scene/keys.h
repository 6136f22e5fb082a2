#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/number_domain.h"
#include "core/scene/object_id.h"

namespace brume {

// Interpolation from a keyframe to the next; `constant` holds the value until there.
enum class Interpolation { smooth, linear, constant };

// A keyframe.
template <class T>
struct Key {
  double time = 0.0;  // [s]
  T value{};
  Interpolation interpolation = Interpolation::smooth;
  ObjectId id = 0;
  // Tangents: the slope of what is `smooth` before and after it, by component [value/s]; absent:
  // automatic. Rotations have none.
  std::optional<T> in{};
  std::optional<T> out{};
  bool aligned = false;  // for editors: who moves one tangent moves the other, too

  bool operator==(const Key&) const = default;
};

// Keyframes of a value, ordered by time, at least min_key_distance apart; empty: constant.
template <class T>
using Keys = std::vector<Key<T>>;

inline constexpr double min_key_distance = 1e-6;  // [s]

// Evaluates at a time [s]; at least one key. Constant before the first key and after the last.
// Vectors by component. `smooth` is a cubic in Hermite form. Its automatic slopes are those of the
// monotone cubic of Fritsch and Butland ("A method for constructing local monotone piecewise cubic
// interpolants", 1984), zero at both ends: between keys without tangents values stay between those
// of the keys, so densities never become negative. Tangents may lead outside.
double value_at(const Keys<double>& keys, double time);
glm::dvec2 value_at(const Keys<glm::dvec2>& keys, double time);
glm::dvec3 value_at(const Keys<glm::dvec3>& keys, double time);
// Unit quaternions, from each to the next the shortest way at the angle that turned_angles() has
// then (slerp).
glm::dquat value_at(const Keys<glm::dquat>& keys, double time);

// How far keys of a rotation have turned since the first [degrees].
Keys<double> turned_angles(const Keys<glm::dquat>& keys);

// The same within a domain, where tangents lead outside.
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
template <class T>
T value_at(const Keys<T>& keys, double time, const NumberDomain& domain) {
  return nearest(domain, value_at(keys, time));
}

// The largest value that keys may have at any time, or one above it; at least one key.
double upper_bound(const Keys<double>& keys);

// Slopes of a smooth curve at key i: its tangents, or the automatic ones.
template <class T>
struct Slopes {
  T in{};
  T out{};
};
Slopes<double> slopes_at(const Keys<double>& keys, std::size_t i);
Slopes<glm::dvec2> slopes_at(const Keys<glm::dvec2>& keys, std::size_t i);
Slopes<glm::dvec3> slopes_at(const Keys<glm::dvec3>& keys, std::size_t i);

// Integral of the value from one time to another, in either order [s]; at least one key.
double integral(const Keys<double>& keys, double begin, double end);
glm::dvec3 integral(const Keys<glm::dvec3>& keys, double begin, double end);
// Of the value, or of `floor` where tangents lead below it; no key is.
double integral_above(double floor, const Keys<double>& keys, double begin, double end);

// Inserts a key, replacing one nearer than min_key_distance.
template <class T>
void set_key(Keys<T>& keys, const Key<T>& key);
// The key at a time, or end().
template <class T>
typename Keys<T>::const_iterator find_key(const Keys<T>& keys, double time);

}  // namespace brume
