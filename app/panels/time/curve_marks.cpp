#include "app/panels/time/curve_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/time/curve_axes.h"

namespace brume {
namespace {

constexpr double grab_radius = 7.0;      // pixels
constexpr double tangent_length = 44.0;  // pixels

double distance_of(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

// The end of a tangent, on one side of its key as it lies on the screen.
QPointF tip_of(const QPointF& key, TangentSide side, double slope, double value_per_pixel,
               const CurveAxes& axes) {
  const double dx = 1.0 / axes.time_per_pixel();
  const double dy = -slope / value_per_pixel;
  const double length = std::hypot(dx, dy);
  const double sign = side == TangentSide::out ? 1.0 : -1.0;
  return key + sign * tangent_length / length * QPointF(dx, dy);
}

bool is_before(const CurveMark& mark, const CurveMark& other) {
  return std::pair(mark.curve, mark.time) < std::pair(other.curve, other.time);
}

}  // namespace

bool CurveMark::is(const CurveMark& other) const {
  return curve == other.curve && is_same_key_time(time, other.time);
}

bool CurveSelection::contains(const CurveMark& mark) const {
  const auto next = std::lower_bound(marks_.begin(), marks_.end(), mark, is_before);
  return (next != marks_.end() && next->is(mark)) ||
         (next != marks_.begin() && (next - 1)->is(mark));
}

void CurveSelection::set(std::vector<CurveMark> marks) {
  std::ranges::sort(marks, is_before);
  const auto doubled =
      std::ranges::unique(marks, [](const CurveMark& a, const CurveMark& b) { return a.is(b); });
  marks.erase(doubled.begin(), doubled.end());
  marks_ = std::move(marks);
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
  for (auto& [track, times] : keys) {
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end(), is_same_key_time), times.end());
  }
  return keys;
}

void CurveSelection::toggle(const CurveMark& mark) {
  if (std::erase_if(marks_, [&mark](const CurveMark& other) { return other.is(mark); }) > 0) return;
  marks_.insert(std::upper_bound(marks_.begin(), marks_.end(), mark, is_before), mark);
}

void CurveSelection::prune(const std::vector<Curve>& curves) {
  std::vector<CurveMark> kept;
  for (const CurveMark& mark : all_marks(curves)) {
    if (contains(mark)) kept.push_back(mark);
  }
  marks_ = std::move(kept);
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
                                   const QPointF& position) {
  std::optional<CurveMark> nearest;
  double min_distance = grab_radius;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (const Curve::Point& point : curves[k].points()) {
      const double distance =
          distance_of(axes.position(point.time, point.value, curves[k].track), position);
      if (distance > min_distance) continue;
      min_distance = distance;
      nearest = CurveMark{k, point.time};
    }
  }
  return nearest;
}

std::optional<TangentHandle> handle_near(const std::vector<TangentHandle>& handles,
                                         const QPointF& position) {
  std::optional<TangentHandle> nearest;
  double min_distance = grab_radius;
  for (const TangentHandle& handle : handles) {
    const double distance = distance_of(handle.tip, position);
    if (distance > min_distance) continue;
    min_distance = distance;
    nearest = handle;
  }
  return nearest;
}

std::size_t curve_near(const std::vector<Curve>& curves, const CurveAxes& axes,
                       const QPointF& position) {
  const double time = axes.time_at(position.x());
  const auto distance = [&](const Curve& curve) {
    return std::abs(axes.position(time, curve.at(time), curve.track).y() - position.y());
  };
  return static_cast<std::size_t>(std::ranges::min_element(curves, {}, distance) - curves.begin());
}

std::vector<CurveMark> all_marks(const std::vector<Curve>& curves) {
  std::vector<CurveMark> marks;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (const Curve::Point& point : curves[k].points()) marks.push_back({k, point.time});
  }
  return marks;
}

}  // namespace brume
