#pragma once

#include <QDialog>

class QActionGroup;
class QFormLayout;

namespace brume {

class Autosave;

// A user's choices for all scenes: applied at once, kept for later sessions. It is not modal.
class Preferences : public QDialog {
  Q_OBJECT
 public:
  // `window`: of the commands whose keys are changed.
  Preferences(Autosave& autosave, QWidget* window);

  // Adds a choice that a menu of the window has, too.
  void add_choice(const QString& title, const QString& name, QActionGroup& group);

 private:
  void add_autosave(Autosave& autosave);
  void add_threads();
  void add_limits();

  QFormLayout* form_;
  int choices_ = 0;  // that menus have, too
};

// The most threads that render, as chosen; 0: as many as there are cores. Call before anything is
// rendered.
void apply_chosen_threads();

}  // namespace brume
