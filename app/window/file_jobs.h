#pragma once

#include <QObject>
#include <filesystem>

#include "app/jobs/background_job.h"
#include "app/window/workspace.h"

class QDropEvent;
class QPointF;
class QWidget;

namespace brume {

class ImportedReload;
class SceneImport;
class View;

// Imports, and exports other than frames, in the background: one at a time.
class FileJobs : public QObject {
  Q_OBJECT
 public:
  // `window`: what dialogs belong to.
  FileJobs(const Workspace& work, QWidget* window);

  [[nodiscard]] SceneImport& import() { return *import_; }
  [[nodiscard]] BackgroundJob& job() { return job_; }
  [[nodiscard]] BackgroundJob& adjusting() { return adjusting_; }
  // Unless another is running.
  void start(const QString& title, const BackgroundJob::Work& job);

  void export_medium();
  // Copies the scene and all files it refers to into a folder that is not there yet, or is empty.
  void gather();  // into one that is asked for
  void gather_to(const std::filesystem::path& folder);
  void simplify();
  void drop(QDropEvent& event);
  // Adds an asset where a view is pointed at, or uses a brush.
  void add_asset(const std::filesystem::path& file, View& view, QPointF position);
  // Whether imported files have been changed by other programs.
  void check_imported();

 private:
  Workspace work_;
  QWidget* window_;
  BackgroundJob job_{BackgroundJob::Policy::one_at_a_time};
  BackgroundJob adjusting_{BackgroundJob::Policy::latest_wins};  // what was simplified
  SceneImport* import_;
  ImportedReload* reload_;
};

}  // namespace brume
