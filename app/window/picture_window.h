#pragma once

#include <QObject>
#include <memory>

#include "app/pictures/picture_viewer.h"
#include "app/window/workspace.h"

class QAction;
class QMainWindow;

namespace brume {

class FileJobs;

// The picture viewer as a window of its own, which may stand beside the editor and closes with it.
class PictureWindow : public QObject {
  Q_OBJECT
 public:
  // `show` is checked while it is shown, `keep` keeps the picture of the active view.
  PictureWindow(const Workspace& work, FileJobs& jobs, QMainWindow& window, QAction* show,
                QAction* keep);

  [[nodiscard]] PictureSlots& pictures() { return viewer_->pictures(); }
  // Keys of these are those of this window, too.
  void add_actions(const QList<QAction*>& actions) { viewer_->addActions(actions); }
  void show();
  void show_new(std::size_t slot) { viewer_->show_new(slot); }
  void close() { viewer_->close(); }
  void store_place() const;

 private:
  void keep_view();
  void save_picture(const std::shared_ptr<const Picture>& picture, const QString& name,
                    const QString& note);

  Workspace work_;
  FileJobs& jobs_;
  PictureViewer* viewer_;
};

}  // namespace brume
