#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <filesystem>
#include <optional>

#include "app/document/autosave.h"
#include "app/jobs/background_job.h"
#include "core/io/scene/missing_files.h"

class QMenu;
class QWidget;

namespace brume {

class Document;
struct LoadedScene;

// New, open, save, recent files, and the question about unsaved work. Functions return whether they
// succeeded; failed() reports errors. Scenes load in the background; the current one stays until
// then.
class SceneFiles : public QObject {
  Q_OBJECT
 public:
  SceneFiles(Document& document, QWidget* window);

  // Asks for a file.
  void open();
  bool save_as();
  // Asks about unsaved work only.
  bool create();
  void open_file(const std::filesystem::path& file);
  // Opens a scene as a new one without a file, as templates and samples are.
  void open_copy(const std::filesystem::path& file);
  // Asks for a file if there is none.
  bool save();
  bool save_to(const std::filesystem::path& file);

  // Checks in the background whether another program has changed or removed the scene's file, or
  // brought it back; emits changed_on_disk() once per change, and removed(). Happens by itself when
  // the file comes or goes.
  void check_file_version();
  // Checks at once, but only whether the file is missing.
  void check_file_exists();
  // Reloads the changed file; or ignores the change, allowing it to be overwritten.
  void reload();
  void ignore_file_change();

  // Asks for the location of a missing file and reloads the scene with it and other missing files
  // in the same folder.
  void find_missing();

  // Opens a recovery file as a modified state of its original.
  void restore(const RecoveryFile& work);

  // Whether the current scene is saved or may be discarded.
  bool may_discard();

  void fill_recent_menu(QMenu& menu);
  [[nodiscard]] static QStringList recent();  // file names, latest first

  [[nodiscard]] BackgroundJob& loading() { return loading_; }

 Q_SIGNALS:
  void opened();
  void restored(const brume::RecoveryFile& work);
  void failed(const QString& message);
  void warned(const QString& message);
  void changed_on_disk();
  void removed();  // the scene's file; the scene counts as unsaved
  void opened_without(const QStringList& missing, const QString& warnings);

 private:
  // In the background. Files are read from their new location in `found`.
  void load(const std::filesystem::path& file, const FoundFiles& found = {});
  void adopt(LoadedScene& loaded);
  [[nodiscard]] bool lacks_file() const;
  void watch_folder();
  // Whether the scene's file may be overwritten; asks if another program has changed it.
  enum class Replace { yes, elsewhere, no };
  Replace may_replace();
  void remember(const std::filesystem::path& file);

  Document& document_;
  QWidget* window_;
  QFileSystemWatcher folder_watcher_;
  std::optional<FileVersion> other_version_;    // reported by changed_on_disk()
  std::optional<RecoveryFile> restoring_;       // recovery file being loaded
  std::vector<std::filesystem::path> missing_;  // missing files of the scene
  bool is_copy_ = false;                        // what is being loaded becomes a new scene
  std::uint64_t discard_revision_ = 0;          // of unsaved work that was discarded for the load
  BackgroundJob loading_{BackgroundJob::Policy::latest_wins};
  BackgroundJob version_check_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
