#pragma once

#include <QPointF>
#include <optional>
#include <vector>

#include "app/document/time/keyframe_curves.h"

namespace brume {

class CurveAxes;

// A key of a curve: a point in the curve editor.
struct CurveMark {
  std::size_t curve;  // index among those shown
  double time;        // [s]

  [[nodiscard]] bool is(const CurveMark& other) const;
};

// The selected keys of a curve editor.
class CurveSelection {
 public:
  [[nodiscard]] bool contains(const CurveMark& mark) const;
  [[nodiscard]] const std::vector<CurveMark>& marks() const { return marks_; }
  [[nodiscard]] bool empty() const { return marks_.empty(); }
  // The keys of the tracks that the curves are of: each time once, in order.
  [[nodiscard]] std::vector<TrackKeys> keys(const std::vector<Curve>& curves,
                                            const std::vector<Track>& tracks) const;
  void set(std::vector<CurveMark> marks);  // each is taken once
  void toggle(const CurveMark& mark);
  // Forgets keys that are no longer there.
  void prune(const std::vector<Curve>& curves);

 private:
  std::vector<CurveMark> marks_;  // by curve and time
};

// The end of a tangent, to be dragged.
struct TangentHandle {
  CurveMark mark;
  TangentSide side;
  QPointF key;
  QPointF tip;
  bool is_automatic;
};

// The handles of the selected keys, on sides where their curve is smooth.
std::vector<TangentHandle> tangent_handles(const std::vector<Curve>& curves,
                                           const CurveSelection& selection, const CurveAxes& axes);

// The mark nearest to a position, if near.
std::optional<CurveMark> mark_near(const std::vector<Curve>& curves, const CurveAxes& axes,
                                   const QPointF& position);
std::optional<TangentHandle> handle_near(const std::vector<TangentHandle>& handles,
                                         const QPointF& position);
// The curve nearest above or below a position; one of at least one.
std::size_t curve_near(const std::vector<Curve>& curves, const CurveAxes& axes,
                       const QPointF& position);

std::vector<CurveMark> all_marks(const std::vector<Curve>& curves);

}  // namespace brume
