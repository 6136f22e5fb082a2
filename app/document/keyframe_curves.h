#pragma once

#include <QString>
#include <variant>
#include <vector>

#include "app/document/keyframe_tracks.h"

namespace brume {

// One number of a track over time: a component of one of its values.
struct Curve {
  std::size_t value = 0;  // index among the part's animatable values, as Track::first
  int component = 0;
  QString title;  // "position x", "intensity"
  std::variant<Keys<double>, Keys<glm::dvec2>, Keys<glm::dvec3>> keys;

  [[nodiscard]] double at(double time) const;  // [s]; at least one key

  struct Point {
    double time;
    double value;
    Interpolation interpolation;
  };
  [[nodiscard]] std::vector<Point> points() const;
};

// Those of a track that have keys.
std::vector<Curve> curves_of(const Scene& scene, const Track& row);

// Sets that number in the key at a time, as far as it is allowed; no effect without such a key.
void set_key_value(ScenePart& part, const Curve& curve, double time, double value);

}  // namespace brume
