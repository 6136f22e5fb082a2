#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/object_id.h"

namespace brume {

// Interpolation from a keyframe to the next.
enum class Interpolation { smooth, linear };

// A keyframe.
template <class T>
struct Key {
  double time = 0.0;  // [s]
  T value{};
  Interpolation interpolation = Interpolation::smooth;
  ObjectId id = 0;

  bool operator==(const Key&) const = default;
};

// Keyframes of a value, ordered by time, at least min_key_distance apart; empty: constant.
template <class T>
using Keys = std::vector<Key<T>>;

inline constexpr double min_key_distance = 1e-6;  // [s]

// Evaluates at a time [s]; at least one key. Constant before the first key and after the last.
// `smooth` is the monotone cubic of Fritsch and Butland ("A method for constructing local monotone
// piecewise cubic interpolants", 1984) with zero slope at both ends: values stay between their
// neighbouring keys, so densities never become negative. Vectors by component.
double value_at(const Keys<double>& keys, double time);
glm::dvec2 value_at(const Keys<glm::dvec2>& keys, double time);
glm::dvec3 value_at(const Keys<glm::dvec3>& keys, double time);

// Integral of the value from one time to another, in either order [s]; at least one key.
double integral(const Keys<double>& keys, double begin, double end);
glm::dvec3 integral(const Keys<glm::dvec3>& keys, double begin, double end);

// Inserts a key, replacing one nearer than min_key_distance.
template <class T>
void set_key(Keys<T>& keys, const Key<T>& key);
// The key at a time, or end().
template <class T>
typename Keys<T>::const_iterator find_key(const Keys<T>& keys, double time);

}  // namespace brume
