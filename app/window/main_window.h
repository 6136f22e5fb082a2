#pragma once

#include <QMainWindow>

#include "app/document/document.h"
#include "app/window/workspace.h"

namespace brume {

class Autosave;
class FileJobs;
class FrameOutput;
class ImportedReload;
class MessageBar;
class SceneFiles;
class StartPage;
class Timeline;
class ToolBox;
class ViewGrid;
class Viewport;

// The window: the document, its views, tools and timeline, and the parts of app/window around them.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  Document& document() { return document_; }
  SceneFiles& files() { return *files_; }
  Autosave& autosave() { return *autosave_; }
  Viewport& viewport() { return *viewport_; }  // the perspective one
  ViewGrid& views() { return *views_; }
  StartPage& start_page() { return *start_page_; }
  ToolBox& tools() { return *tools_; }
  Timeline& timeline() { return *timeline_; }
  FileJobs& file_jobs() { return *file_jobs_; }
  FrameOutput& output() { return *output_; }

  // Leaves a recovery copy of unsaved work, what is being typed included, before the program is
  // ended from outside.
  void keep_unsaved_work();
  // Stores the layout as it changes, not only when the window is closed.
  void keep_layout();

  // Saves a picture of this window once it shows a full frame and its error, then quits.
  void quit_with_screenshot(const QString& file);

 protected:
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  [[nodiscard]] Workspace workspace();
  void lay_out_center();
  void restore_layout();
  void store_layout();
  void follow_time();
  void offer_recovery();
  void update_title();
  void show_time();  // what the timeline says

  Document document_;
  SceneFiles* files_;
  Autosave* autosave_;
  MessageBar* message_bar_;
  QWidget* bars_ = nullptr;  // messages above the tools' options
  StartPage* start_page_ = nullptr;
  ViewGrid* views_;
  Viewport* viewport_;  // the perspective one
  ToolBox* tools_;
  Timeline* timeline_;
  FileJobs* file_jobs_ = nullptr;
  FrameOutput* output_ = nullptr;
};

}  // namespace brume
