#pragma once

#include <QButtonGroup>
#include <QScrollArea>
#include <vector>

#include "app/pictures/picture_slots.h"

class QAbstractButton;
class QBoxLayout;
class QLabel;
class QToolButton;

namespace brume {

// A tile for each slot: a thumbnail, which shows it as A, the name of its picture, and the buttons
// A and B.
class SlotStrip : public QScrollArea {
  Q_OBJECT
 public:
  explicit SlotStrip(PictureSlots& slots, QWidget* parent = nullptr);

  [[nodiscard]] std::size_t a() const { return static_cast<std::size_t>(a_->checkedId()); }
  [[nodiscard]] std::size_t b() const { return static_cast<std::size_t>(b_->checkedId()); }
  void choose_a(std::size_t slot) { a_->button(static_cast<int>(slot))->setChecked(true); }
  void choose_b(std::size_t slot) { b_->button(static_cast<int>(slot))->setChecked(true); }

 Q_SIGNALS:
  void chosen();  // another slot as A or B

 private:
  struct Tile {
    QToolButton* thumbnail;
    QLabel* name;
    qint64 shown = -1;  // the picture of the thumbnail; 0: none
  };
  void add_tile(QBoxLayout& row, int slot);
  void show_slot(std::size_t slot);

  PictureSlots& slots_;
  QButtonGroup* a_;
  QButtonGroup* b_;
  std::vector<Tile> tiles_;
};

}  // namespace brume
