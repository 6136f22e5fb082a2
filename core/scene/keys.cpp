#include "core/scene/keys.h"

#include <algorithm>
#include <cmath>

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

// Component k between keys i and i + 1.
template <class T>
double between(const Keys<T>& keys, std::size_t i, double time, int k) {
  const auto point = [&](std::size_t j) {
    return Point{keys[j].time, component(keys[j].value, k)};
  };
  const Point a = point(i);
  const Point b = point(i + 1);
  const double length = b.time - a.time;
  const double u = (time - a.time) / length;
  if (keys[i].interpolation == Interpolation::linear) return std::lerp(a.value, b.value, u);
  const double from = i > 0 ? slope(point(i - 1), a, b) : 0.0;
  const double to = i + 2 < keys.size() ? slope(a, b, point(i + 2)) : 0.0;
  const double v = 1.0 - u;
  const double value = a.value + (b.value - a.value) * u * u * (3.0 - 2.0 * u) +
                       length * u * v * (from * v - to * u);
  const auto [min_value, max_value] = std::minmax(a.value, b.value);
  return std::clamp(value, min_value, max_value);  // rounding
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

// Simpson's rule between times without a key in between: exact, since values are cubic there.
template <class T>
T piece(const Keys<T>& keys, double low, double high) {
  return (high - low) / 6.0 *
         (value_at(keys, low) + 4.0 * value_at(keys, 0.5 * (low + high)) + value_at(keys, high));
}

template <class T>
T sum_of_pieces(const Keys<T>& keys, double low, double high) {
  T sum(0.0);
  double last = low;
  for (auto key = first_after(keys, low); key != keys.end() && key->time < high; ++key) {
    sum += piece(keys, last, key->time);
    last = key->time;
  }
  return sum + piece(keys, last, high);
}

template <class T>
T any_order(const Keys<T>& keys, double begin, double end) {
  return begin <= end ? sum_of_pieces(keys, begin, end) : -sum_of_pieces(keys, end, begin);
}

}  // namespace

double value_at(const Keys<double>& keys, double time) {
  if (is_outside(keys, time)) return outside(keys, time);
  return between(keys, last_until(keys, time), time, 0);
}

glm::dvec2 value_at(const Keys<glm::dvec2>& keys, double time) {
  if (is_outside(keys, time)) return outside(keys, time);
  const std::size_t i = last_until(keys, time);
  return {between(keys, i, time, 0), between(keys, i, time, 1)};
}

glm::dvec3 value_at(const Keys<glm::dvec3>& keys, double time) {
  if (is_outside(keys, time)) return outside(keys, time);
  const std::size_t i = last_until(keys, time);
  return {between(keys, i, time, 0), between(keys, i, time, 1), between(keys, i, time, 2)};
}

double integral(const Keys<double>& keys, double begin, double end) {
  return any_order(keys, begin, end);
}

glm::dvec3 integral(const Keys<glm::dvec3>& keys, double begin, double end) {
  return any_order(keys, begin, end);
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

}  // namespace brume
