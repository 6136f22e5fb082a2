#pragma once

#include <QObject>
#include <QPointF>

#include "app/window/workspace.h"
#include "brume/surface.h"

class QMainWindow;
class QMenu;

namespace brume {

class FileJobs;
class Viewport;

// The menu Add, and the menu of what is under the mouse in a view.
class ObjectMenu : public QObject {
  Q_OBJECT
 public:
  ObjectMenu(const Workspace& work, FileJobs& jobs, QMainWindow& window);

  void fill_add_menu(QMenu& menu);
  void show_view_menu(Viewport& view, QPointF position);
  void rename_object();
  void drop_object();

 private:
  void add_primitive(Primitive::Shape shape);
  void add_gaussian_in_view();

  Workspace work_;
  FileJobs& jobs_;
  QMainWindow& window_;
};

}  // namespace brume
