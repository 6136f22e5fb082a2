#pragma once

#include <QWidget>
#include <variant>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/time/keyframe_curves.h"
#include "app/panels/time/curve_axes.h"
#include "app/panels/time/curve_marks.h"
#include "app/widgets/mouse_drag.h"

namespace brume {

class Document;
class Timeline;

// The curves of tracks: their numbers over time, with their keys as points, below a ruler of
// frames. The numbers of each track have an axis of their own; the active one, of the key that was
// selected last, has its values written beside it. Click selects a key, Shift adds to the
// selection, a drag elsewhere draws a rectangle around more. Selected keys are dragged together in
// time and value and show their tangents, whose ends are dragged too (Alt: one side alone). Delete
// deletes; right click opens a menu; double click adds a key. A drag of the playhead scrubs the
// timeline. The wheel zooms (Shift: time only, Ctrl: value only), the middle button pans, Home
// fits, Ctrl+A selects all.
class CurveEditor : public QWidget {
  Q_OBJECT
  Q_PROPERTY(bool keeps_focus READ keeps_focus)  // FieldFilter
 public:
  CurveEditor(Timeline& timeline, Document& document, QWidget* parent);

  // A number of a track that is not to be shown.
  struct Hidden {
    Track track;
    CurveId curve;  // its value counts from the track's first

    bool operator==(const Hidden&) const = default;
  };
  [[nodiscard]] static bool is_hidden(const std::vector<Hidden>& hidden, const Track& track,
                                      const CurveId& curve);
  [[nodiscard]] static Hidden to_hide(const Track& track, const CurveId& curve);
  // Shows tracks but for some of their numbers; none: says how to make one.
  void set_tracks(std::vector<Track> tracks, std::vector<Hidden> hidden);
  // Shows the present curves of these tracks, which may be elsewhere in their part.
  void update_tracks(std::vector<Track> tracks, std::vector<Hidden> hidden);
  void fit();

  [[nodiscard]] const std::vector<Track>& tracks() const { return tracks_; }
  [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }
  [[nodiscard]] const CurveSelection& selection() const { return selection_; }
  // Keys are about the selected keyframes, wherever the mouse is.
  [[nodiscard]] bool keeps_focus() const { return !selection_.empty(); }
  [[nodiscard]] QPointF position(double time, double value, std::size_t track = 0) const {
    return axes_.position(time, value, track);
  }
  [[nodiscard]] QColor color(std::size_t curve) const;
  [[nodiscard]] std::vector<TangentHandle> handles() const {
    return tangent_handles(curves_, selection_, axes_);
  }
  [[nodiscard]] QSize sizeHint() const override { return {400, 180}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 40}; }

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  // The drag of keys while a button is down.
  struct KeysDrag {
    std::vector<ScenePart> parts_at_start;
    std::vector<CurveMark> marks;  // where they were
    std::vector<double> values;
    CurveMark grabbed;
    QPointF press;
    double frames_per_pixel;  // as at the press: rulers may follow the last key
    MergeId gesture;
    bool has_moved = false;
  };
  struct TangentDrag {
    std::vector<ScenePart> parts_at_start;
    CurveMark mark;
    double key_value;
    TangentSide side;
    MergeId gesture;
    bool has_moved = false;
  };
  struct RectangleDrag {
    QPointF press;
    QPointF now;
    std::vector<CurveMark> kept;  // selected besides
  };
  struct Scrub {};
  struct Pan {
    QPointF last;
  };

  void refresh();
  [[nodiscard]] std::vector<Hidden> shown_numbers() const;
  void press_left(const QPointF& press, bool adds);
  void press_key(const CurveMark& mark, const QPointF& press, bool adds);
  void drag_keys(KeysDrag& drag, const QPointF& to);
  void drag_tangent(TangentDrag& drag, const QPointF& to, bool alone);
  void drag_rectangle(RectangleDrag& drag, const QPointF& to);
  [[nodiscard]] const Track& track_of(const CurveMark& mark) const;
  [[nodiscard]] std::vector<TrackKeys> selected_keys() const;
  [[nodiscard]] QPen pen(std::size_t curve) const;
  [[nodiscard]] double value_of(const CurveMark& mark) const;
  void paint_curve(QPainter& painter, std::size_t k) const;
  void paint_handles(QPainter& painter) const;
  void cancel_drag();
  void delete_selected();
  void level(double value);  // sets that value in all selected keys

  Timeline& timeline_;
  Document& document_;
  std::vector<Track> tracks_;
  std::vector<Hidden> hidden_;
  std::vector<Curve> curves_;
  CurveAxes axes_{timeline_};
  std::size_t active_ = 0;  // the track whose values are written
  CurveSelection selection_;
  std::variant<std::monostate, KeysDrag, TangentDrag, RectangleDrag, Scrub, Pan> drag_;
  MouseDrag mouse_{this};
};

}  // namespace brume
