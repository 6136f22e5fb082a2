#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <optional>

#include "app/document/autosave.h"
#include "app/file_reader.h"

class QMenu;
class QWidget;

namespace brume {

class Document;
class SceneLoad;
struct LoadedScene;

// New, open, save, recent files, and the one question about unsaved work. Every bool answers
// whether it was done; what went wrong is said by failed(). Scenes are read in the background; the
// present one stays until the other is complete.
class SceneFiles : public QObject {
  Q_OBJECT
 public:
  SceneFiles(Document& document, QWidget* window);

  // Asks for a file.
  void open();
  bool save_as();
  // Asks only what to do with unsaved work.
  bool create();
  void open_file(const std::filesystem::path& file);
  // Asks for a file if the scene has none yet.
  bool save();
  bool save_to(const std::filesystem::path& file);

  // Looks in the background whether another program has changed the scene's file since; says so
  // with changed_on_disk(), once for each such change.
  void look_at_file();
  // Reads the file again, as open_file() does, or lets it be: what it holds may then be replaced.
  void reload();
  void keep_mine();

  // Asks where a file is that the scene refers to and that was missing, and opens the scene again
  // with it, and with others that are missing and lie in the same folder.
  void find_missing();

  // Opens work that was left behind, unsaved, as a later state of its file.
  void restore(const LeftBehind& work);

  // Whether the present scene may go: saved, or the user does not want it.
  bool may_discard();

  void fill_recent_menu(QMenu& menu);

  // Reads the scenes, and shows that it does.
  [[nodiscard]] SceneLoad& loading() { return *loading_; }

 Q_SIGNALS:
  void opened();
  void restored(const brume::LeftBehind& work);
  void failed(const QString& message);
  void warned(const QString& message);
  void changed_on_disk();
  void opened_without(const QStringList& missing, const QString& warnings);

 private:
  void take(LoadedScene& loaded);
  // Whether the scene's file may be replaced; if another program has changed it, asks.
  enum class Replace { yes, elsewhere, no };
  Replace may_replace();
  void remember(const std::filesystem::path& file);

  Document& document_;
  QWidget* window_;
  SceneLoad* loading_;
  FileReader<std::optional<FileVersion>> version_reader_;
  std::optional<FileVersion> other_version_;    // that changed_on_disk() told of
  std::optional<LeftBehind> restoring_;         // what is being read is this
  std::vector<std::filesystem::path> missing_;  // files that the scene was opened without
  int asked_at_ = 0;  // where in the history unsaved work was given up for what is being read
};

}  // namespace brume
