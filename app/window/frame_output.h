#pragma once

#include <QList>
#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "app/export/frame_export.h"
#include "app/window/workspace.h"
#include "brume/output.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QTabWidget;

namespace brume {

class FileJobs;
class CameraPanel;
class OutputPanel;
class PictureWindow;
class RenderQueue;

// Pictures and animations on their way to files and to the picture viewer: the menu Render, and the
// dock Output.
class FrameOutput : public QObject {
  Q_OBJECT
 public:
  FrameOutput(const Workspace& work, FileJobs& jobs, QMainWindow& window);

  // The dock Output as a tab beside another.
  void add_docks(QDockWidget* beside);
  void fill_menu(QMenu& menu);
  // Check boxes of what the view shows of the camera.
  [[nodiscard]] const QList<QAction*>& camera_actions() const { return camera_actions_; }
  // Lines over the camera's picture.
  [[nodiscard]] const QList<QAction*>& guide_actions() const { return guide_actions_; }
  [[nodiscard]] RenderQueue& queue() { return *queue_; }
  [[nodiscard]] PictureWindow& pictures() { return *pictures_; }
  // The dock Output: where the file is named, the cameras, the queue.
  void show_output();
  void show_camera(std::size_t place);  // 0 is in use, k + 1 the k-th other
  void show_queue() { show_tab(2); }

 private:
  [[nodiscard]] QAction* make_action(const QString& text, const char* name, const QString& tip);
  void create_actions(FileJobs& jobs);
  void create_camera_actions();
  void create_guide_actions();
  [[nodiscard]] QTabWidget* make_tabs();
  [[nodiscard]] FrameExportRequest view_request(const std::filesystem::path& file) const;
  [[nodiscard]] FrameExportRequest output_request(bool animation) const;
  void render(bool animation);
  [[nodiscard]] bool may_write(const std::filesystem::path& file, bool animation);
  void show_tab(int index);  // of the dock Output
  void show_render(int id);
  void mark_region();

  Workspace work_;
  QMainWindow& window_;
  RenderQueue* queue_;
  QDockWidget* output_dock_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  OutputPanel* output_ = nullptr;
  CameraPanel* cameras_ = nullptr;
  PictureWindow* pictures_ = nullptr;
  QAction* viewer_action_ = nullptr;
  QAction* keep_action_ = nullptr;
  QList<QAction*> actions_;  // in the order of the menu Render
  QList<QAction*> camera_actions_;
  QList<QAction*> guide_actions_;
  int shown_render_ = 0;  // id in the queue, whose pictures the viewer shows
  // Files of output that may be replaced: of one picture, or of an animation.
  std::set<std::pair<std::filesystem::path, bool>> rendered_files_;
};

}  // namespace brume
