#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/key_rows.h"

namespace brume {

class Document;
class Timeline;

// The keys of a scene, a row for each value that has some: a diamond is a smooth key, a square a
// linear one. A click chooses a key, a drag moves it from frame to frame, Delete deletes it, a
// right click offers what else there is, a double click beside it makes one; beside the keys a drag
// moves the frame that is shown.
class KeyStrip : public QWidget {
  Q_OBJECT
 public:
  KeyStrip(Timeline& timeline, Document& document, QWidget* parent);

  // Where the first and the last frame of the range are [pixels from the left]: where the slider
  // has them. Titles stand left of them.
  void set_ends(double first_x, double last_x);

  // Where the key of a row would stand at a frame.
  [[nodiscard]] QPoint position(std::size_t row, int frame) const;
  [[nodiscard]] const std::vector<KeyRow>& rows() const { return rows_; }

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
  [[nodiscard]] int frame_at(double x) const;  // within the range
  [[nodiscard]] std::optional<Mark> mark_at(QPointF position) const;
  [[nodiscard]] bool is_chosen(std::size_t row, double time) const;
  void delete_chosen();

  double first_x_ = 0.0;
  double last_x_ = 1.0;
  Timeline& timeline_;
  Document& document_;
  std::vector<KeyRow> rows_;
  std::vector<std::vector<KeyMark>> marks_;  // of each row
  std::optional<Mark> chosen_;
  // The drag of a key: the part as it was, where the key was and where it is.
  struct Drag {
    ScenePart before;
    double from;
    double to;
    MergeId gesture;
  };
  std::optional<Drag> drag_;
  bool scrubs_ = false;
};

}  // namespace brume
