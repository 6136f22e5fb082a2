#pragma once

#include <QObject>
#include <vector>

#include "app/window/workspace.h"

class QLabel;
class QMainWindow;

namespace brume {

class BackgroundJob;

// The window's words on the scene, the frame of the active view, its error and background work:
// in its status bar and in the upper right corner; once, too, why OpenGL does not render and which
// frame of a sequence cannot be read.
class StatusLine : public QObject {
  Q_OBJECT
 public:
  StatusLine(const Workspace& work, QMainWindow& window, const std::vector<BackgroundJob*>& jobs);

  // All but the jobs, while something covers the scene.
  void hide_scene(bool hidden);

 private:
  void update_numbers();
  void update_error();
  void show_fallback();
  void show_unreadable_frame();

  Workspace work_;
  QString fallback_;    // the reason that was told last; empty: none
  QString unreadable_;  // the same of frames of sequences
  QLabel* hint_;
  QLabel* numbers_;
  QLabel* error_;
  QLabel* quality_;  // top right
};

}  // namespace brume
