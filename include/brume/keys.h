#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "brume/export.h"
#include "brume/object_id.h"

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
BRUME_EXPORT double value_at(const Keys<double>& keys, double time);
BRUME_EXPORT glm::dvec2 value_at(const Keys<glm::dvec2>& keys, double time);
BRUME_EXPORT glm::dvec3 value_at(const Keys<glm::dvec3>& keys, double time);
// Unit quaternions, from each to the next the shortest way at the angle that turned_angles() has
// then (slerp).
BRUME_EXPORT glm::dquat value_at(const Keys<glm::dquat>& keys, double time);

// How far keys of a rotation have turned since the first [degrees].
BRUME_EXPORT Keys<double> turned_angles(const Keys<glm::dquat>& keys);

// The largest value that keys may have at any time, or one above it; at least one key.
BRUME_EXPORT double upper_bound(const Keys<double>& keys);

// Slopes of a smooth curve at key i: its tangents, or the automatic ones.
template <class T>
struct Slopes {
  T in{};
  T out{};
};
BRUME_EXPORT Slopes<double> slopes_at(const Keys<double>& keys, std::size_t i);
BRUME_EXPORT Slopes<glm::dvec2> slopes_at(const Keys<glm::dvec2>& keys, std::size_t i);
BRUME_EXPORT Slopes<glm::dvec3> slopes_at(const Keys<glm::dvec3>& keys, std::size_t i);

// Integral of the value from one time to another, in either order [s]; at least one key.
BRUME_EXPORT double integral(const Keys<double>& keys, double begin, double end);
BRUME_EXPORT glm::dvec3 integral(const Keys<glm::dvec3>& keys, double begin, double end);
// The integral of the value, or of `floor` where tangents lead below it; no key is.
BRUME_EXPORT double integral_above(double floor, const Keys<double>& keys, double begin,
                                   double end);

// Inserts a key, replacing one nearer than min_key_distance.
template <class T>
BRUME_EXPORT void set_key(Keys<T>& keys, const Key<T>& key);
// The key at a time, or end().
template <class T>
BRUME_EXPORT typename Keys<T>::const_iterator find_key(const Keys<T>& keys, double time);

}  // namespace brume
