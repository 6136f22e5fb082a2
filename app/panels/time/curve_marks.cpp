#include "app/panels/time/curve_marks.h"

#include <algorithm>
#include <cmath>

#include "app/panels/time/curve_axes.h"

namespace brume {
namespace {

constexpr double grab_radius = 7.0;      // pixels
constexpr double tangent_length = 44.0;  // pixels

double distance_of(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

// From a key towards the side of a tangent, as it lies on the screen.
QPointF tip_of(const QPointF& key, TangentSide side, double slope, double value_per_pixel,
               const CurveAxes& axes) {
  const double dx = 1.0 / axes.time_per_pixel();
  const double dy = -slope / value_per_pixel;
  const double length = std::hypot(dx, dy);
  const double sign = side == TangentSide::out ? 1.0 : -1.0;
  return key + sign * tangent_length / length * QPointF(dx, dy);
}

}  // namespace

bool CurveMark::is(const CurveMark& other) const {
  return curve == other.curve && std::abs(time - other.time) < min_key_distance;
}

bool CurveSelection::contains(const CurveMark& mark) const {
  return std::ranges::any_of(marks_, [&mark](const CurveMark& m) { return m.is(mark); });
}

std::vector<TrackKeys> CurveSelection::keys(const std::vector<Curve>& curves,
                                            const std::vector<Track>& tracks) const {
  std::vector<TrackKeys> keys;
  for (const CurveMark& mark : marks_) {
    const Track& track = tracks[curves[mark.curve].track];
    auto found = std::ranges::find(keys, track, &TrackKeys::track);
    if (found == keys.end()) found = keys.insert(found, {track, {}});
    found->times.push_back(mark.time);
  }
  const auto is_same = [](double a, double b) { return b - a < min_key_distance; };
  for (auto& [track, times] : keys) {
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end(), is_same), times.end());
  }
  return keys;
}

void CurveSelection::add(const CurveMark& mark) {
  if (!contains(mark)) marks_.push_back(mark);
}

void CurveSelection::toggle(const CurveMark& mark) {
  if (std::erase_if(marks_, [&mark](const CurveMark& m) { return m.is(mark); }) == 0) {
    marks_.push_back(mark);
  }
}

void CurveSelection::prune(const std::vector<Curve>& curves) {
  if (marks_.empty()) return;
  const std::vector<CurveMark> there = all_marks(curves);
  std::erase_if(marks_, [&there](const CurveMark& mark) {
    return std::ranges::none_of(there, [&mark](const CurveMark& m) { return m.is(mark); });
  });
}

std::vector<TangentHandle> tangent_handles(const std::vector<Curve>& curves,
                                           const CurveSelection& selection, const CurveAxes& axes) {
  std::vector<TangentHandle> handles;
  for (std::size_t k = 0; k < curves.size() && !selection.empty(); ++k) {
    if (curves[k].is_rotation) continue;
    const std::vector<Curve::Point> points = curves[k].points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Curve::Point& point = points[i];
      const CurveMark mark{k, point.time};
      if (!selection.contains(mark)) continue;
      const QPointF key = axes.position(point.time, point.value, curves[k].track);
      const auto add = [&](TangentSide side, double slope) {
        handles.push_back({mark, side, key,
                           tip_of(key, side, slope, axes.value_per_pixel(curves[k].track), axes),
                           point.tangents == Tangents::automatic});
      };
      if (i > 0 && points[i - 1].interpolation == Interpolation::smooth) {
        add(TangentSide::in, point.slopes.in);
      }
      if (i + 1 < points.size() && point.interpolation == Interpolation::smooth) {
        add(TangentSide::out, point.slopes.out);
      }
    }
  }
  return handles;
}

std::optional<CurveMark> mark_near(const std::vector<Curve>& curves, const CurveAxes& axes,
                                   const QPointF& at) {
  std::optional<CurveMark> nearest;
  double min_distance = grab_radius;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (const Curve::Point& point : curves[k].points()) {
      const double distance =
          distance_of(axes.position(point.time, point.value, curves[k].track), at);
      if (distance > min_distance) continue;
      min_distance = distance;
      nearest = CurveMark{k, point.time};
    }
  }
  return nearest;
}

std::optional<TangentHandle> handle_near(const std::vector<TangentHandle>& handles,
                                         const QPointF& at) {
  std::optional<TangentHandle> nearest;
  double min_distance = grab_radius;
  for (const TangentHandle& handle : handles) {
    const double distance = distance_of(handle.tip, at);
    if (distance > min_distance) continue;
    min_distance = distance;
    nearest = handle;
  }
  return nearest;
}

std::vector<CurveMark> all_marks(const std::vector<Curve>& curves) {
  std::vector<CurveMark> marks;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (const Curve::Point& point : curves[k].points()) marks.push_back({k, point.time});
  }
  return marks;
}

}  // namespace brume
