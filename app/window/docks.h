#pragma once

#include <QObject>

#include "app/panels/lists/outliner.h"
#include "app/window/workspace.h"

class QDockWidget;
class QMainWindow;

namespace brume {

class FileJobs;
class FrameOutput;
class TimelineBar;

// The panels of the window, and what connects them to the views.
class Docks : public QObject {
  Q_OBJECT
 public:
  Docks(const Workspace& work, FrameOutput& output, FileJobs& jobs, QMainWindow& window);

  [[nodiscard]] TimelineBar& timeline_bar() { return *timeline_bar_; }

 private:
  QDockWidget* add(const QString& title, const char* name, QWidget* panel);
  void add_scene_panels();
  void add_frame_panels();
  void add_time_panels();
  void add_assets(FileJobs& jobs);
  void show_panel_of(Outliner::Kind kind, std::size_t index);

  Workspace work_;
  FrameOutput& output_;
  QMainWindow& window_;
  QDockWidget* outliner_ = nullptr;
  QDockWidget* gaussians_ = nullptr;
  QDockWidget* lights_ = nullptr;
  QDockWidget* medium_ = nullptr;
  QDockWidget* surfaces_ = nullptr;
  QDockWidget* emitters_ = nullptr;
  QDockWidget* groups_ = nullptr;
  TimelineBar* timeline_bar_ = nullptr;
};

}  // namespace brume
