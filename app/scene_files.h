#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <optional>

#include "app/document/autosave.h"

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

 private:
  void take(LoadedScene& loaded);
  void remember(const std::filesystem::path& file);

  Document& document_;
  QWidget* window_;
  SceneLoad* loading_;
  std::optional<LeftBehind> restoring_;  // what is being read is this
  int asked_at_ = 0;  // where in the history unsaved work was given up for what is being read
};

}  // namespace brume
