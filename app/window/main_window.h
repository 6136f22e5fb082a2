#pragma once

#include <QMainWindow>
#include <filesystem>
#include <optional>
#include <set>

#include "app/document/document.h"
#include "app/jobs/background_job.h"

class QAction;
class QDockWidget;
class QLabel;
class QMenu;

namespace brume {

class Autosave;
class FrameExport;
struct FrameExportRequest;
class GaussianPanel;
class ImportedReload;
class MessageBar;
struct Picture;
class PictureViewer;
class RenderQueue;
class SceneFiles;
class SceneImport;
class StartPage;
class Timeline;
class TimelineBar;
class ToolBox;
class ViewGrid;
class Viewport;

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

  // Exports what the view sees, on the scene's film; path-traced with `paths` per pixel, or by the
  // method of the view.
  void export_frame_to(const std::filesystem::path& file, std::optional<int> paths = {},
                       const OutputLayers& layers = {}, int bits = 8);

  // The frames of the timeline that are named, numbered or as a video, by the file's extension: as
  // the scene's camera sees them if it has keys, else as the view does.
  void export_animation_to(const std::filesystem::path& file, int first, int last);

  // What comes from other files.
  SceneImport& import() { return *import_; }
  // Copies the scene and all files it refers to into a folder that is not there yet, or is empty.
  void gather_to(const std::filesystem::path& folder);

  // Leaves a recovery copy of unsaved work, what is being typed included, before the program is
  // ended from outside.
  void keep_unsaved_work();

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
  void create_docks();       // main_window_docks.cpp
  void create_status_bar();  // main_window_status.cpp
  // main_window_output.cpp
  void create_output_docks(QDockWidget* beside);
  void create_output_actions();
  void fill_render_menu(QMenu* menu);
  [[nodiscard]] FrameExportRequest output_request(bool animation) const;
  void render_output(bool animation);
  void show_render(int id);
  void show_picture_viewer();
  [[nodiscard]] bool may_end_renders();  // asks if any is not done
  void keep_view();
  void save_kept_picture(const std::shared_ptr<const Picture>& picture);
  void mark_region();

  void create_actions();  // main_window_actions.cpp
  void look_through_light();
  void fill_add_menu(QMenu* menu);  // main_window_objects.cpp
  void show_view_menu(Viewport& view, QPointF position);
  void add_primitive(Primitive::Shape shape);
  void rename_object();
  void show_preferences();
  void fill_backend_menu(QMenu* menu);
  void fill_mode_menu(QMenu* menu);
  void fill_navigation_menu(QMenu* menu);
  void fill_theme_menu(QMenu* menu);
  void connect_document();
  void offer_recovery();

  void update_title();
  void update_status();
  void update_error();
  void show_fallback();  // why OpenGL does not render, once for each reason
  void show_unreadable_frame();
  void add_gaussian_in_view();
  void isolate_selection();  // shows all again if anything is hidden
  void export_frame();
  void export_animation();
  void export_medium();
  void gather();
  // Unless another is running.
  void show_simplify();
  void start_file_job(const QString& title, const BackgroundJob::Work& work);
  [[nodiscard]] FrameExportRequest export_request(const std::filesystem::path& file) const;
  void change_exposure(double stops);
  void save_current_picture();  // of the scene as it is in its file
  void show_time();             // what the timeline says
  void show_status(const QString& message);

  Document document_;
  SceneFiles* files_;
  Autosave* autosave_;
  MessageBar* message_bar_;
  StartPage* start_page_ = nullptr;
  ViewGrid* views_;
  Viewport* viewport_;  // the perspective one
  ToolBox* tools_;
  Timeline* timeline_;
  TimelineBar* timeline_bar_ = nullptr;
  GaussianPanel* gaussian_panel_ = nullptr;
  FrameExport* frame_export_ = nullptr;
  RenderQueue* render_queue_ = nullptr;
  PictureViewer* picture_viewer_ = nullptr;
  QList<QAction*> output_actions_;  // in the order of the menu Render
  QList<QAction*> camera_actions_;  // check boxes of what the view shows of the camera
  int shown_render_ = 0;            // id in the queue, whose pictures the viewer shows
  // Files of output that may be replaced: of one picture, or of an animation.
  std::set<std::pair<std::filesystem::path, bool>> rendered_files_;
  BackgroundJob* file_job_ = nullptr;  // imports, exports of the medium, gathers
  SceneImport* import_ = nullptr;
  ImportedReload* imported_reload_ = nullptr;
  std::pair<std::filesystem::path, std::uint64_t> pictured_;  // file and revision
  QString fallback_;    // the reason that was told last; empty: none
  QString unreadable_;  // the same of frames of sequences
  QLabel* hint_ = nullptr;
  QLabel* numbers_ = nullptr;
  QLabel* error_ = nullptr;
  QLabel* quality_ = nullptr;  // top right
};

}  // namespace brume
