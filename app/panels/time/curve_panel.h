#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "app/panels/time/curve_editor.h"

class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

class Document;
class Timeline;

// A curve editor below a ruler of frames, beside the list of all values with keyframes and of their
// numbers. Checked ones are shown; a double click on one shows it alone.
class CurvePanel : public QWidget {
  Q_OBJECT
 public:
  CurvePanel(Timeline& timeline, Document& document, QWidget* parent);

  // Shows the curves of values alone, or of the tracks that they are in; nothing changes if none of
  // them has keyframes.
  void show_tracks(std::span<const Track> tracks);

 private:
  void clear();  // another scene was opened
  void refresh();
  void follow(const ObjectPlaces& places);
  void fill_list();
  void follow_list();  // shows what is checked
  void paint_icons();
  void check_all(Qt::CheckState state);
  void isolate(QTreeWidgetItem* item);
  void show_menu(const QPoint& position);

  Document& document_;
  QTreeWidget* list_;
  CurveEditor* editor_;
  // A row of the list, with the numbers that its children are of.
  struct Listed {
    Track track;
    std::vector<std::size_t> values;  // as those of KeyedTrack
    std::vector<CurveId> curves;
    std::vector<QString> titles;
  };
  [[nodiscard]] static bool is_row_of(const Listed& row, const KeyedTrack& keyed);

  std::vector<Listed> listed_;
  std::vector<Track> shown_;
  std::vector<CurveEditor::Hidden> hidden_;
};

}  // namespace brume
