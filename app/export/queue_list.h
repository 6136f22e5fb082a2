#pragma once

#include <QWidget>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace brume {

class RenderQueue;

// The renders of a queue, with what may be done with them.
class QueueList : public QWidget {
  Q_OBJECT
 public:
  explicit QueueList(RenderQueue& queue, QWidget* parent = nullptr);

 Q_SIGNALS:
  void show_asked_for(int id);  // the picture of a render

 private:
  void rebuild();
  void show_time_left();
  void show_progress(int id, int percent);
  void add_buttons(QGridLayout& layout);
  void add_details(QGridLayout& layout);
  void update_buttons();
  void show_details();
  void show_menu(const QPoint& position);
  void move_to_row(int id, int row);
  void open_folder();
  [[nodiscard]] int current() const;  // id; 0: none

  RenderQueue& queue_;
  QTreeWidget* list_;
  QLabel* empty_;
  QLabel* details_ = nullptr;
  QComboBox* priority_ = nullptr;
  QPushButton* show_ = nullptr;
  QPushButton* folder_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* resume_ = nullptr;
  QPushButton* sooner_ = nullptr;
  QPushButton* later_ = nullptr;
  QPushButton* remove_ = nullptr;
};

// Whether the renders of a queue may be stopped; asks if any is not done.
bool may_stop(const RenderQueue& queue, QWidget* window);

}  // namespace brume
