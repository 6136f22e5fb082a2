// The menus, and with them every key.

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "app/commands/edit_medium.h"
#include "app/commands/set_camera_command.h"
#include "app/frame_export.h"
#include "app/help_windows.h"
#include "app/main_window.h"
#include "app/scene_files.h"
#include "app/viewport/viewport.h"

namespace brume {
namespace {

constexpr const char* airlight_key = "view/airlight";

}  // namespace

void MainWindow::create_actions() {
  const auto add = [this](QMenu* menu, const QString& text, const QList<QKeySequence>& keys,
                          auto react) {
    QAction* action = menu->addAction(text);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, react);
    return action;
  };

  QMenu* file = menuBar()->addMenu(tr("&File"));
  add(file, tr("&New"), {QKeySequence("Ctrl+N")}, [this] { files_->create(); });
  add(file, tr("&Open…"), {QKeySequence("Ctrl+O")}, [this] { files_->open(); });
  QMenu* recent = file->addMenu(tr("Open &Recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { files_->fill_recent_menu(*recent); });
  file->addSeparator();
  add(file, tr("&Save"), {QKeySequence("Ctrl+S")}, [this] { files_->save(); });
  add(file, tr("Save &As…"), {QKeySequence("Ctrl+Shift+S")}, [this] { files_->save_as(); });
  file->addSeparator();
  QAction* exporting =
      add(file, tr("&Export Frame…"), {QKeySequence("Ctrl+E")}, [this] { export_frame(); });
  connect(file, &QMenu::aboutToShow, this,
          [this, exporting] { exporting->setEnabled(!frame_export_->is_running()); });
  connect(file, &QMenu::aboutToHide, this, [exporting] { exporting->setEnabled(true); });
  file->addSeparator();
  add(file, tr("&Quit"), {QKeySequence("Ctrl+Q")}, [this] { close(); });

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undo_stack().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence("Ctrl+Z"));
  undo->setIconText(tr("Undo"));
  QAction* redo = document_.undo_stack().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  edit->addAction(undo);
  edit->addAction(redo);
  edit->addSeparator();
  add(edit, tr("Add &Gaussian"), {QKeySequence("Shift+A")}, [this] { add_gaussian_in_view(); });
  QAction* remove = add(edit, tr("&Delete"), {QKeySequence("Del"), QKeySequence("X")},
                        [this] { delete_selection(document_); });
  edit->addSeparator();
  add(edit, tr("Select &All"), {QKeySequence("Ctrl+A")}, [this] { document_.select_all(); });
  add(edit, tr("Select &None"), {QKeySequence("Ctrl+Shift+A")}, [this] { document_.select({}); });
  add(edit, tr("&Invert Selection"), {QKeySequence("Ctrl+I")},
      [this] { document_.invert_selection(); });
  const auto enable_delete = [this, remove] { remove->setEnabled(!document_.selection().empty()); };
  connect(&document_, &Document::selection_changed, this, enable_delete);
  enable_delete();

  QMenu* view = menuBar()->addMenu(tr("&View"));
  add(view, tr("Frame &All"), {QKeySequence("Home")}, [this] { viewport_->frame_all(); });
  add(view, tr("&Frame Selection"), {QKeySequence("F")}, [this] { viewport_->frame_selection(); });
  add(view, tr("&Scene Camera"), {QKeySequence("0")},
      [this] { viewport_->set_camera(document_.scene().camera); });
  add(view, tr("S&tore View as Scene Camera"), {QKeySequence("Ctrl+0")}, [this] {
    if (viewport_->camera() != document_.scene().camera) {
      document_.undo_stack().push(new SetCameraCommand(document_, viewport_->camera()));
    }
  });
  view->addSeparator();
  add(view, tr("Exposure &Up"), {QKeySequence("+"), QKeySequence("=")},
      [this] { change_exposure(0.5); });
  add(view, tr("Exposure &Down"), {QKeySequence("-")}, [this] { change_exposure(-0.5); });
  fill_airlight_menu(view->addMenu(tr("Air&light")));
  view->addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Keys"), {QKeySequence("?"), QKeySequence("F1")}, [this, file, edit, view] {
    show_keys(this, file->actions() + edit->actions() + view->actions());
  });
  add(help, tr("&About Brume"), {}, [this] { show_about(this); });
}

void MainWindow::fill_airlight_menu(QMenu* menu) {
  FrameQuality& quality = viewport_->quality();
  const QString remembered = QSettings().value(airlight_key).toString();
  auto* group = new QActionGroup(this);
  const auto add = [&](const char* name, const QString& text,
                       std::optional<AirlightMethod> method) {
    if (remembered == name) quality.set_airlight(method);
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setObjectName(QString("airlight_") + name);
    action->setChecked(quality.airlight() == method);
    connect(action, &QAction::triggered, this, [&quality, name, method] {
      quality.set_airlight(method);
      QSettings().setValue(airlight_key, name);
    });
  };
  add("auto", tr("&Auto"), std::nullopt);
  add(to_string(AirlightMethod::paper), tr("&Paper"), AirlightMethod::paper);
  add(to_string(AirlightMethod::sliced), tr("&Sliced"), AirlightMethod::sliced);
  menu->addActions(group->actions());
}

}  // namespace brume
