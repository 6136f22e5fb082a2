#pragma once

#include <QObject>

#include "app/window/workspace.h"

class QMainWindow;
class QMenu;

namespace brume {

class Autosave;
class FileJobs;
class FrameOutput;
class ObjectMenu;
class StartPage;
class TimelineBar;

// The menus of the window, and with them every key.
class MainMenu : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    FileJobs& jobs;
    FrameOutput& output;
    ObjectMenu& objects;
    StartPage& start_page;
    Autosave& autosave;
    TimelineBar& timeline_bar;
  };
  MainMenu(const Workspace& work, const Parts& parts, QMainWindow& window);

 private:
  QAction* add(QMenu* menu, const QString& text, const char* name, auto react);
  void fill_file_menu(QMenu* menu);
  void fill_edit_menu(QMenu* menu);
  void fill_select_menu(QMenu* menu);
  void fill_tool_menu(QMenu* menu);
  void fill_time_menu(QMenu* menu);
  void fill_view_menu(QMenu* menu);
  void fill_help_menu(QMenu* menu, const QList<QMenu*>& others);
  void fill_mode_menu(QMenu* menu);
  void fill_backend_menu(QMenu* menu);
  void fill_navigation_menu(QMenu* menu);
  void fill_theme_menu(QMenu* menu);
  void delete_selected();
  void isolate_selection();
  void look_through_light();
  void change_exposure(double stops);
  void show_preferences();

  Workspace work_;
  Parts parts_;
  QMainWindow& window_;
};

}  // namespace brume
