#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/keyframe_tracks.h"
#include "app/widgets/mouse_drag.h"

namespace brume {

class Document;
class Timeline;

// The keyframe tracks of a scene: diamonds are smooth keys, squares linear ones, triangles
// constant ones. Click selects, drag moves, Delete deletes, right click opens a menu, double click
// adds a key; dragging elsewhere scrubs the timeline. Below them the animations of imported scenes,
// whose keys are only shown.
class KeyframeTrack : public QWidget {
  Q_OBJECT
 public:
  KeyframeTrack(Timeline& timeline, Document& document, QWidget* parent);

  // Positions of the first and last frame [pixels from the left], aligned with the slider; titles
  // are left of them.
  void set_ends(double first_x, double last_x);

  // Position of a track's key at a frame.
  [[nodiscard]] QPoint position(std::size_t row, int frame) const;
  [[nodiscard]] const std::vector<Track>& rows() const { return rows_; }

  [[nodiscard]] QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Mark {
    std::size_t row;
    double time;
  };
  void refresh();
  [[nodiscard]] double x_of(double frame) const;
  [[nodiscard]] int frame_at(double x) const;  // clamped to the range
  [[nodiscard]] std::optional<Mark> mark_at(QPointF position) const;
  [[nodiscard]] bool is_chosen(std::size_t row, double time) const;
  void drag_to(double time);
  void delete_chosen();

  double first_x_ = 0.0;
  double last_x_ = 1.0;
  Timeline& timeline_;
  Document& document_;
  std::vector<Track> rows_;
  std::vector<std::vector<Keyframe>> marks_;  // per track
  std::optional<Mark> chosen_;
  // A drag of a key: original part, original and current time.
  struct Drag {
    ScenePart before;
    double from;
    double to;
    MergeId gesture;
  };
  std::optional<Drag> drag_;
  MouseDrag mouse_{this};
  bool scrubs_ = false;
};

}  // namespace brume
