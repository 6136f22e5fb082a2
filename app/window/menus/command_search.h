#pragma once

#include <QFrame>
#include <vector>

class QAction;
class QLineEdit;
class QListWidget;
class QMenuBar;

namespace brume {

// A field that finds the commands of the menus by words of their names, in any order, and runs the
// chosen one. Closes when it has, at Esc, and at a click beside it.
class CommandSearch : public QFrame {
  Q_OBJECT
 public:
  // Commands of submenus that are filled when they are opened are not found.
  CommandSearch(const QMenuBar& menus, QWidget* parent);

  void open();  // below the top of the parent

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Command {
    QString title;  // "View › Show › Error"
    QAction* action;
  };
  void collect(const QList<QAction*>& actions, const QString& path);
  void list_matches();
  void run();

  std::vector<Command> commands_;
  QLineEdit* words_;
  QListWidget* list_;
};

}  // namespace brume
