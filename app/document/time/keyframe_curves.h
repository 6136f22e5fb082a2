#pragma once

#include <QString>
#include <variant>
#include <vector>

#include "app/document/time/keyframe_tracks.h"
#include "core/number_domain.h"

namespace brume {

// A number of a track: a component of one of its values.
struct CurveId {
  std::size_t value = 0;  // index among the part's animatable values, as Track::first
  int component = 0;

  bool operator==(const CurveId&) const = default;
};

// That number over time. A rotation is one curve, of how far it has turned [degrees].
struct Curve : CurveId {
  std::size_t track = 0;  // its track's place among those shown together
  QString title;          // "position x", "intensity"
  NumberDomain domain;
  std::variant<Keys<double>, Keys<glm::dvec2>, Keys<glm::dvec3>> keys;
  bool is_rotation = false;  // its keys have no tangents, and move in time only

  [[nodiscard]] double at(double time) const;  // [s]; at least one key

  struct Point {
    double time;
    double value;
    Interpolation interpolation;
    Tangents tangents;
    Slopes<double> slopes;
  };
  [[nodiscard]] std::vector<Point> points() const;
  [[nodiscard]] double key_value(double time) const;  // 0 without a key at the time [s]
};

// The curves of a track's numbers that have keys.
std::vector<Curve> curves_of(const Scene& scene, const Track& row);

// Edits of that number in the key at a time, as far as it is allowed; no effect without such a key.
void set_key_value(ScenePart& part, const CurveId& curve, double time, double value);
// Sets the slope on one side of the key [1/s]. Automatic tangents become aligned, aligned ones stay
// so; `alone` makes them free.
enum class TangentSide { in, out };
struct TangentEdit {
  double time;
  TangentSide side;
  double slope;
  bool alone;
};
void set_tangent(ScenePart& part, const CurveId& curve, const TangentEdit& edit);

}  // namespace brume
