#pragma once

#include <QWidget>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace brume {

// The table of keys, to be changed: at once, and for later sessions. A key has one command: one
// that had it before loses it, and the widget says so.
class KeyPreferences : public QWidget {
  Q_OBJECT
 public:
  // `window`: of the commands, its actions that are named in the table of keys.
  explicit KeyPreferences(QWidget& window, QWidget* parent = nullptr);

 private:
  [[nodiscard]] QAction* current() const;
  void list_matches();
  void show_current();
  void set_keys(QAction& action, const QList<QKeySequence>& keys);
  void take_entered();
  void reset(QAction& action);
  void reset_all();
  void show_keys();

  QList<QAction*> actions_;  // in the order of the table of keys
  QLineEdit* filter_;
  QTreeWidget* list_;
  QKeySequenceEdit* edit_;
  QLabel* note_;
};

}  // namespace brume
