#pragma once

#include <QWidget>
#include <optional>
#include <variant>
#include <vector>

#include "app/commands/objects/edit_keys.h"
#include "app/panels/time/dope_rows.h"
#include "app/panels/time/time_ruler.h"
#include "app/widgets/mouse_drag.h"

namespace brume {

class Document;

// The keyframes of a scene below a ruler: diamonds are smooth keys, squares linear ones, triangles
// constant ones. Names at the left are chosen with the mouse; a click on an object's triangle folds
// its values. Click selects a key, Shift or a rectangle several; a drag moves them to other frames,
// Delete deletes, Ctrl+C and Ctrl+V copy, right click opens a menu, double click adds a key.
class DopeSheet : public QWidget {
  Q_OBJECT
  Q_PROPERTY(bool keeps_focus READ keeps_focus)  // FieldFilter
 public:
  static constexpr int names_width = 190;  // pixels

  DopeSheet(Timeline& timeline, Document& document, QWidget* parent);

  void set_filter(const QString& filter);
  // Shows all keyframes.
  void fit();

  [[nodiscard]] const std::vector<DopeRow>& rows() const { return rows_; }
  // The middle of a row's key at a frame, and of its name.
  [[nodiscard]] QPoint position(std::size_t row, int frame) const;
  [[nodiscard]] QPoint name_position(std::size_t row) const;
  [[nodiscard]] const KeySelection& selection() const { return selection_; }
  // Keys are about the selected keyframes, wherever the mouse is.
  [[nodiscard]] bool keeps_focus() const { return !selection_.empty(); }
  // The values whose names are chosen.
  [[nodiscard]] const std::vector<Track>& chosen() const { return chosen_; }

 Q_SIGNALS:
  void chosen_changed();
  void curves_asked_for();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  struct Mark {
    std::size_t row;
    double time;
  };
  struct KeysDrag {
    std::vector<ScenePart> parts_at_start;
    std::vector<TrackKeys> keys;  // where they were
    Mark grabbed;
    QPointF press;
    double frames_per_pixel;  // as at the press: rulers may follow the last key
    MergeId gesture;
    bool has_moved = false;
  };
  struct RectangleDrag {
    QPointF press;
    QPointF now;
    KeySelection kept;  // selected besides
  };
  struct Pan {
    double last_x;
  };

  void refresh();
  // Follows objects that are elsewhere in their part, or gone.
  void follow(const ObjectPlaces& places);
  [[nodiscard]] FrameScale scale() const;
  [[nodiscard]] int frame_near(double x) const;  // >= 0
  [[nodiscard]] std::optional<std::size_t> row_at(double y) const;
  [[nodiscard]] std::optional<Mark> mark_at(QPointF position) const;
  void press_name(std::size_t row, const QMouseEvent& event);
  void press_key(const Mark& mark, const QMouseEvent& event);
  void drag_keys(KeysDrag& drag, const QPointF& to);
  void drag_rectangle(RectangleDrag& drag, const QPointF& to);
  void cancel_drag();
  void choose(std::vector<Track> tracks);
  void select_all();
  void delete_selected();
  void copy_selected();
  void paste();
  [[nodiscard]] bool acts_on(const QKeyEvent& key) const;
  void paint_row(QPainter& painter, std::size_t row) const;
  void paint_keys(QPainter& painter, std::size_t row) const;

  Timeline& timeline_;
  Document& document_;
  QString filter_;
  std::set<DopeObject> folded_;
  std::vector<DopeRow> rows_;
  KeySelection selection_;
  std::vector<Track> chosen_;
  std::optional<CopiedKeys> copied_;
  std::variant<std::monostate, KeysDrag, RectangleDrag, Pan> drag_;
  MouseDrag mouse_{this};
};

}  // namespace brume
