#include "brume/keys.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <type_traits>

#include "core/math/hermite_cubic.h"

namespace brume {
namespace {

double component(double value, int) {
  return value;
}
double component(const glm::dvec2& value, int k) {
  return value[k];
}
double component(const glm::dvec3& value, int k) {
  return value[k];
}

struct Point {
  double time;
  double value;
};

double chord(const Point& a, const Point& b) {
  return (b.value - a.value) / (b.time - a.time);
}

// The derivative at b: a weighted harmonic mean of the chords on both sides; 0 at an extremum.
double slope(const Point& a, const Point& b, const Point& c) {
  const double before = chord(a, b);
  const double after = chord(b, c);
  if (!(before * after > 0.0)) return 0.0;
  const double left = 2.0 * (c.time - b.time) + (b.time - a.time);
  const double right = (c.time - b.time) + 2.0 * (b.time - a.time);
  return (left + right) / (left / before + right / after);
}

// The automatic slope of component k at key i.
template <class T>
double automatic_slope(const Keys<T>& keys, std::size_t i, int k) {
  if (i == 0 || i + 1 == keys.size()) return 0.0;
  const auto point = [&](std::size_t j) {
    return Point{keys[j].time, component(keys[j].value, k)};
  };
  return slope(point(i - 1), point(i), point(i + 1));
}

template <class T>
double slope_of(const std::optional<T>& tangent, const Keys<T>& keys, std::size_t i, int k) {
  return tangent ? component(*tangent, k) : automatic_slope(keys, i, k);
}

template <class T>
bool has_tangents(const Keys<T>& keys, std::size_t i) {
  return keys[i].interpolation == Interpolation::smooth && (keys[i].out || keys[i + 1].in);
}

// Component k from key i to key i + 1, where that is smooth.
template <class T>
HermiteCubic cubic(const Keys<T>& keys, std::size_t i, int k) {
  const Key<T>& a = keys[i];
  const Key<T>& b = keys[i + 1];
  return {.length = b.time - a.time,
          .begin = component(a.value, k),
          .end = component(b.value, k),
          .begin_slope = slope_of(a.out, keys, i, k),
          .end_slope = slope_of(b.in, keys, i + 1, k)};
}

// Component k between keys i and i + 1.
template <class T>
double between(const Keys<T>& keys, std::size_t i, double time, int k) {
  const double a = component(keys[i].value, k);
  const double b = component(keys[i + 1].value, k);
  const double since = time - keys[i].time;
  if (keys[i].interpolation == Interpolation::constant) return a;
  if (keys[i].interpolation == Interpolation::linear) {
    return std::lerp(a, b, since / (keys[i + 1].time - keys[i].time));
  }
  const double value = cubic(keys, i, k).value(since);
  if (has_tangents(keys, i)) return value;
  const auto [min_value, max_value] = std::minmax(a, b);
  return std::clamp(value, min_value, max_value);  // rounding
}

void set_component(double& value, int, double number) {
  value = number;
}
void set_component(auto& value, int k, double number) {
  value[k] = number;
}

template <class T>
constexpr int components_of = std::is_same_v<T, double>       ? 1
                              : std::is_same_v<T, glm::dvec2> ? 2
                                                              : 3;

template <class T>
T all_between(const Keys<T>& keys, std::size_t i, double time) {
  T value{};
  for (int k = 0; k < components_of<T>; ++k) set_component(value, k, between(keys, i, time, k));
  return value;
}

template <class T>
Slopes<T> all_slopes_at(const Keys<T>& keys, std::size_t i) {
  Slopes<T> slopes;
  for (int k = 0; k < components_of<T>; ++k) {
    set_component(slopes.in, k, slope_of(keys[i].in, keys, i, k));
    set_component(slopes.out, k, slope_of(keys[i].out, keys, i, k));
  }
  return slopes;
}

template <class T>
typename Keys<T>::const_iterator first_after(const Keys<T>& keys, double time) {
  return std::upper_bound(keys.begin(), keys.end(), time,
                          [](double t, const Key<T>& key) { return t < key.time; });
}

// Index of the last key that is not after `time`; there is one.
template <class T>
std::size_t last_until(const Keys<T>& keys, double time) {
  return static_cast<std::size_t>(first_after(keys, time) - keys.begin()) - 1;
}

template <class T>
bool is_outside(const Keys<T>& keys, double time) {
  return !(time > keys.front().time) || time >= keys.back().time;
}

template <class T>
const T& outside(const Keys<T>& keys, double time) {
  return time >= keys.back().time ? keys.back().value : keys.front().value;
}

template <class T>
T evaluated(const Keys<T>& keys, double time) {
  if (is_outside(keys, time)) return outside(keys, time);
  return all_between(keys, last_until(keys, time), time);
}

// Sums integrals from `low` to `high` of what is before the first key and after the last, and of
// piece(i, from, to) of each interval from key i to the next.
template <class T>
T sum_of_pieces(const Keys<T>& keys, double low, double high, const auto& piece) {
  const double first = keys.front().time;
  const double last = keys.back().time;
  T sum = std::max(0.0, std::min(high, first) - low) * keys.front().value +
          std::max(0.0, high - std::max(low, last)) * keys.back().value;
  std::size_t i = low > first ? last_until(keys, low) : 0;
  for (; i + 1 < keys.size() && keys[i].time < high; ++i) {
    const double start = std::max(low, keys[i].time);
    const double to = std::min(high, keys[i + 1].time);
    if (start < to) sum += piece(i, start, to);
  }
  return sum;
}

template <class T>
T in_any_order(const Keys<T>& keys, double begin, double end, const auto& piece) {
  return begin <= end ? sum_of_pieces(keys, begin, end, piece)
                      : -sum_of_pieces(keys, end, begin, piece);
}

// Simpson's rule between times without a key in between: exact, since values are cubic there.
template <class T>
auto simpson(const Keys<T>& keys) {
  return [&keys](std::size_t i, double low, double high) {
    return (high - low) / 6.0 *
           (all_between(keys, i, low) + 4.0 * all_between(keys, i, 0.5 * (low + high)) +
            all_between(keys, i, high));
  };
}

double turned_angle(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat turn = glm::conjugate(a) * b;
  return glm::degrees(
      2.0 * std::atan2(glm::length(glm::dvec3(turn.x, turn.y, turn.z)), std::abs(turn.w)));
}

}  // namespace

double value_at(const Keys<double>& keys, double time) {
  return evaluated(keys, time);
}

glm::dvec2 value_at(const Keys<glm::dvec2>& keys, double time) {
  return evaluated(keys, time);
}

glm::dvec3 value_at(const Keys<glm::dvec3>& keys, double time) {
  return evaluated(keys, time);
}

glm::dquat value_at(const Keys<glm::dquat>& keys, double time) {
  if (is_outside(keys, time)) return outside(keys, time);
  const std::size_t i = last_until(keys, time);
  // Slopes need only the neighbours.
  const std::size_t begin = std::max<std::size_t>(i, 1) - 1;
  const std::size_t end = std::min(i + 3, keys.size());
  const auto iterator_at = [&keys](std::size_t k) {
    return keys.begin() + static_cast<std::ptrdiff_t>(k);
  };
  const Keys<double> angles = turned_angles({iterator_at(begin), iterator_at(end)});
  const double first_angle = angles[i - begin].value;
  const double whole = angles[i - begin + 1].value - first_angle;
  const double turned = value_at(angles, time) - first_angle;
  if (!(turned > 0.0)) return keys[i].value;
  const double u = std::min(turned / whole, 1.0);
  return glm::normalize(glm::slerp(keys[i].value, keys[i + 1].value, u));
}

Keys<double> turned_angles(const Keys<glm::dquat>& keys) {
  Keys<double> angles;
  angles.reserve(keys.size());
  double angle = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0) angle += turned_angle(keys[i - 1].value, keys[i].value);
    angles.push_back(
        {.time = keys[i].time, .value = angle, .interpolation = keys[i].interpolation});
  }
  return angles;
}

double upper_bound(const Keys<double>& keys) {
  double bound = keys.front().value;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    bound = std::max(bound, keys[i].value);
    if (i + 1 < keys.size() && has_tangents(keys, i)) {
      bound = std::max(bound, cubic(keys, i, 0).upper_bound());
    }
  }
  return bound;
}

Slopes<double> slopes_at(const Keys<double>& keys, std::size_t i) {
  return all_slopes_at(keys, i);
}

Slopes<glm::dvec2> slopes_at(const Keys<glm::dvec2>& keys, std::size_t i) {
  return all_slopes_at(keys, i);
}

Slopes<glm::dvec3> slopes_at(const Keys<glm::dvec3>& keys, std::size_t i) {
  return all_slopes_at(keys, i);
}

double integral(const Keys<double>& keys, double begin, double end) {
  return in_any_order(keys, begin, end, simpson(keys));
}

glm::dvec3 integral(const Keys<glm::dvec3>& keys, double begin, double end) {
  return in_any_order(keys, begin, end, simpson(keys));
}

double integral_above(double floor, const Keys<double>& keys, double begin, double end) {
  const auto piece = [&](std::size_t i, double low, double high) {
    if (!has_tangents(keys, i)) return simpson(keys)(i, low, high);
    const double start = keys[i].time;
    return cubic(keys, i, 0).integral_above(floor, low - start, high - start);
  };
  return in_any_order(keys, begin, end, piece);
}

template <class T>
typename Keys<T>::const_iterator find_key(const Keys<T>& keys, double time) {
  return std::find_if(keys.begin(), keys.end(), [time](const Key<T>& key) {
    return std::abs(key.time - time) < min_key_distance;
  });
}

template <class T>
void set_key(Keys<T>& keys, const Key<T>& key) {
  std::erase_if(keys, [&key](const Key<T>& other) {
    return std::abs(other.time - key.time) < min_key_distance;
  });
  keys.insert(first_after(keys, key.time), key);
}

template void set_key(Keys<double>&, const Key<double>&);
template void set_key(Keys<glm::dvec2>&, const Key<glm::dvec2>&);
template void set_key(Keys<glm::dvec3>&, const Key<glm::dvec3>&);
template Keys<double>::const_iterator find_key(const Keys<double>&, double);
template Keys<glm::dvec2>::const_iterator find_key(const Keys<glm::dvec2>&, double);
template Keys<glm::dvec3>::const_iterator find_key(const Keys<glm::dvec3>&, double);
template void set_key(Keys<glm::dquat>&, const Key<glm::dquat>&);
template Keys<glm::dquat>::const_iterator find_key(const Keys<glm::dquat>&, double);

}  // namespace brume
