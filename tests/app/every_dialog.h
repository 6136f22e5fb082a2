#pragma once

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <functional>

#include "app/import/dialogs/folder_dialog.h"
#include "app/import/dialogs/scene_dialog.h"
#include "app/import/dialogs/splat_dialog.h"
#include "app/import/dialogs/volume_dialog.h"
#include "app/widgets/color_button.h"
#include "core/scene/imported_scene.h"
#include "tests/app/test_window.h"

namespace brume {

// Calls `visit` for each dialog of the editor that is not the system's, one after another and
// shown; returns how many there are.
inline int visit_dialogs(TestWindow& window, const std::function<void(QWidget&)>& visit) {
  int count = 0;
  const auto visit_open = [&] {
    for (QWidget* dialog : window->findChildren<QWidget*>()) {
      const bool is_dialog = dialog->isWindow() && !qobject_cast<QMenu*>(dialog) &&
                             !qobject_cast<QDockWidget*>(dialog);
      if (!is_dialog || !dialog->isVisible()) continue;
      visit(*dialog);
      ++count;
      delete dialog;
      return;
    }
  };
  const auto visit_new = [&](QDialog* dialog) {
    dialog->show();
    visit_open();
  };
  for (const char* name : {"edit.preferences", "edit.find_command", "edit.simplify", "help.keys"}) {
    invoke(*window, name);
    visit_open();
  }
  for (const char* text : {"Add Shape…", "About Brume", "Export Medium…", "Save Current As…"}) {
    for (QMenu* menu : window->findChildren<QMenu*>()) Q_EMIT menu->aboutToShow();
    trigger(*window, text);
    visit_open();
  }
  window->findChild<ColorButton*>("light_color")->click();
  visit_open();
  const std::filesystem::path smoke = BRUME_RESOURCES "/volumes/smoke_0025.vdb";
  const FrameRun run = frames_around(smoke);
  visit_new(new VolumeDialog(smoke, run, &*window));
  visit_new(new VolumeDialog(smoke, {}, &*window));
  visit_new(new SplatDialog("splats.ply", run, &*window));
  visit_new(new FolderDialog(smoke, run, &*window));
  ImportedScene imported;
  imported.files = {"street.glb"};
  visit_new(new SceneDialog(imported, &*window));
  return count;
}

}  // namespace brume
