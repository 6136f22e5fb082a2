#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace brume {

// How a value goes from a key to the next.
enum class Interpolation { smooth, linear };

// A value at a moment.
template <class T>
struct Key {
  double time = 0.0;  // [s]
  T value{};
  Interpolation interpolation = Interpolation::smooth;
  std::string unknown{};  // as UnknownKeys of core/scene/scene.h

  bool operator==(const Key&) const = default;
};

// What makes a value change over time; without keys it stays as it is. Ordered by time, at least
// least_key_distance apart.
template <class T>
using Keys = std::vector<Key<T>>;

inline constexpr double least_key_distance = 1e-6;  // [s]

// The value at a moment [s]; there is at least one key. Before the first key and after the last it
// stays. `smooth` is the monotone cubic of Fritsch and Butland ("A method for constructing local
// monotone piecewise cubic interpolants", 1984), at rest at the first and at the last key: no value
// leaves the interval between the keys around it, so that no density becomes negative. Components
// of a vector go each by itself.
double value_at(const Keys<double>& keys, double time);
glm::dvec3 value_at(const Keys<glm::dvec3>& keys, double time);

// Puts a key among the others, in place of one that is nearer than least_key_distance.
template <class T>
void set_key(Keys<T>& keys, const Key<T>& key);
// The key at a moment, or the end.
template <class T>
typename Keys<T>::const_iterator find_key(const Keys<T>& keys, double time);

}  // namespace brume
