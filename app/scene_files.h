#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>

class QMenu;
class QWidget;

namespace brume {

class Document;

// New, open, save, recent files, and the one question about unsaved work. Every bool answers
// whether it was done; what went wrong is said by failed().
class SceneFiles : public QObject {
  Q_OBJECT
 public:
  SceneFiles(Document& document, QWidget* window);

  // Asks for a file.
  bool open();
  bool save_as();
  // Asks only what to do with unsaved work.
  bool create();
  bool open_file(const std::filesystem::path& file);
  // Asks for a file if the scene has none yet.
  bool save();
  bool save_to(const std::filesystem::path& file);

  // Whether the present scene may go: saved, or the user does not want it.
  bool may_discard();

  void fill_recent_menu(QMenu& menu);

 Q_SIGNALS:
  void failed(const QString& message);
  void warned(const QString& message);

 private:
  void remember(const std::filesystem::path& file);

  Document& document_;
  QWidget* window_;
};

}  // namespace brume
