#pragma once

#include <QWidget>

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
  void update_buttons();
  void open_folder();
  [[nodiscard]] int current() const;  // id; 0: none

  RenderQueue& queue_;
  QTreeWidget* list_;
  QLabel* empty_;
  QPushButton* show_;
  QPushButton* folder_;
  QPushButton* cancel_;
  QPushButton* resume_;
  QPushButton* sooner_;
  QPushButton* later_;
  QPushButton* remove_;
};

// Whether the renders of a queue may be stopped; asks if any is not done.
bool may_stop(const RenderQueue& queue, QWidget* window);

}  // namespace brume
