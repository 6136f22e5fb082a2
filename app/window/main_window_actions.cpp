// The menus, and with them every key.

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "app/commands/clipboard.h"
#include "app/commands/edit_emitters.h"
#include "app/commands/edit_groups.h"
#include "app/commands/edit_keys.h"
#include "app/commands/edit_lights.h"
#include "app/commands/edit_medium.h"
#include "app/commands/edit_objects.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/select_command.h"
#include "app/document/timeline.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_files.h"
#include "app/import/scene_import.h"
#include "app/panels/lists/outliner.h"
#include "app/panels/plots/performance_panel.h"
#include "app/panels/time/timeline_bar.h"
#include "app/tools/tool_bars.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/application.h"
#include "app/window/dialogs/help_windows.h"
#include "app/window/dialogs/preferences.h"
#include "app/window/main_window.h"
#include "app/window/menus/color_menu.h"
#include "app/window/menus/command_search.h"
#include "app/window/menus/fog_menu.h"
#include "app/window/menus/ground_grid_action.h"
#include "app/window/menus/group_menu.h"
#include "app/window/menus/layout_menu.h"
#include "app/window/menus/menu_action.h"
#include "app/window/menus/quality_menu.h"
#include "app/window/pages/start_page.h"
#include "core/io/disk/installed_files.h"

namespace brume {
namespace {

constexpr const char* backend_key = "view/backend";
constexpr const char* navigation_key = "view/navigation";
constexpr double tool_step = 1.15;  // of a tool's size by one key

constexpr double duplicate_shift = 24.0;  // pixels, so that a copy is seen beside its original

std::vector<GaussianId> joined(std::vector<GaussianId> a, const std::vector<GaussianId>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

void MainWindow::look_through_light() {
  const Scene& scene = document_.scene();
  if (document_.active_light() >= scene.lights.size()) return;
  const Light& light = scene.lights[document_.active_light()];
  viewport_->camera_controller().set_camera(
      camera_at(light, LitRegion::of(scene), viewport_->camera().target));
}

void MainWindow::create_actions() {
  const auto add = [this](QMenu* menu, const QString& text, const char* name, auto react) {
    return add_action(menu, text, name, this, react);
  };

  QMenu* file = menuBar()->addMenu(tr("&File"));
  add(file, tr("&New"), "file.new", [this] { files_->create(); });
  add(file, tr("&Open…"), "file.open", [this] { files_->open(); });
  QMenu* recent = file->addMenu(tr("Open &Recent"));
  show_large_icons(*recent);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { files_->fill_recent_menu(*recent); });
  add(file, tr("Start Pa&ge"), "file.start_page", [this] { start_page_->open(); });
  file->addSeparator();
  add(file, tr("&Save"), "file.save", [this] { files_->save(); });
  add(file, tr("Save &As…"), "file.save_as", [this] { files_->save_as(); });
  file->addSeparator();
  add(file, tr("&Import…"), "file.import", [this] { import_->ask(); });
  add(file, tr("Import Se&quence…"), "", [this] { import_->ask_sequence(); });
  file->addSeparator();
  add(file, tr("&Export Frame…"), "file.export", [this] { export_frame(); });
  add(file, tr("Export Ani&mation…"), "", [this] { export_animation(); });
  add(file, tr("Export Me&dium…"), "", [this] { export_medium(); });
  add(file, tr("&Gather into Folder…"), "", [this] { gather(); });
  file->addSeparator();
  add(file, tr("&Quit"), "file.quit", [this] { close(); });

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = document_.undo_stack().createUndoAction(this, tr("&Undo"));
  undo->setObjectName("edit.undo");
  undo->setShortcuts(keys_of("edit.undo"));
  undo->setIconText(tr("Undo"));
  QAction* redo = document_.undo_stack().createRedoAction(this, tr("&Redo"));
  redo->setObjectName("edit.redo");
  redo->setShortcuts(keys_of("edit.redo"));
  edit->addAction(undo);
  edit->addAction(redo);
  edit->addSeparator();
  add(edit, tr("Fi&nd Command…"), "edit.find_command",
      [this] { (new CommandSearch(*menuBar(), this))->open(); });
  add(edit, tr("Prefere&nces…"), "edit.preferences", [this] { show_preferences(); });
  edit->addSeparator();
  add(edit, tr("Cu&t"), "edit.cut", [this] { cut_selection(document_); });
  add(edit, tr("&Copy"), "edit.copy", [this] { copy_selection(document_); });
  add(edit, tr("&Paste"), "edit.paste", [this] {
    paste_gaussians(document_, views_->pointed().place_under_mouse(clipboard_radius()));
  });
  add(edit, tr("Paste in Pl&ace"), "edit.paste_in_place",
      [this] { paste_gaussians(document_, std::nullopt); });
  add(edit, tr("D&uplicate"), "edit.duplicate", [this] {
    if (document_.object()) return duplicate_object(document_, *document_.object());
    duplicate_selection(document_,
                        views_->active().shift_on_film({duplicate_shift, duplicate_shift}));
  });
  add(edit, tr("&Delete"), "edit.delete", [this] {
    if (const auto object = document_.object()) {
      delete_object(document_, *object);
      return document_.set_object(std::nullopt);  // a second key deletes no other one
    }
    delete_selection(document_, tr("Delete"));
  });
  add(edit, tr("Simplif&y…"), "edit.simplify", [this] { show_simplify(); });
  QAction* rename = add(edit, tr("Rena&me"), "edit.rename", [this] { rename_object(); });
  // Elsewhere F2 edits the cell of a table.
  rename->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  views_->addAction(rename);
  findChild<Outliner*>()->addAction(rename);

  QMenu* adding = menuBar()->addMenu(tr("&Add"));
  adding->setObjectName("add_menu");
  fill_add_menu(adding);

  QMenu* select = menuBar()->addMenu(tr("&Select"));
  add(select, tr("&All"), "select.all", [this] { select_all(document_); });
  add(select, tr("&None"), "select.none", [this] { select_gaussians(document_, {}); });
  add(select, tr("&Invert"), "select.invert", [this] { invert_selection(document_); });
  add(select, tr("&Grow"), "select.grow", [this] { grow_selection(document_); });
  add(select, tr("Shrin&k"), "select.shrink", [this] { shrink_selection(document_); });
  select->addSeparator();
  add(select, tr("Gr&oup Selection"), "select.group", [this] { group_selection(document_); });
  add(select, tr("Ungroup S&election"), "select.ungroup", [this] { ungroup_selection(document_); });
  QMenu* to_group = select->addMenu(tr("Mo&ve to Group"));
  to_group->setObjectName("move_to_group");
  connect(to_group, &QMenu::aboutToShow, this,
          [this, to_group] { fill_group_menu(*to_group, document_); });
  select->addSeparator();
  add(select, tr("&Hide"), "select.hide", [this] {
    if (document_.object()) return show_object(document_, *document_.object(), false);
    document_.hide(joined(document_.hidden(), document_.selection()));
  });
  add(select, tr("Isola&te"), "select.isolate", [this] { isolate_selection(); });
  add(select, tr("&Show All"), "select.show_all", [this] { document_.hide({}); });
  add(select, tr("&Lock"), "select.lock", [this] {
    if (document_.object()) return lock_object(document_, *document_.object(), true);
    document_.lock(joined(document_.locked(), document_.selection()));
  });
  add(select, tr("&Unlock All"), "select.unlock_all", [this] { document_.lock({}); });

  QMenu* tool = menuBar()->addMenu(tr("&Tool"));
  tool->addActions(findChild<ToolBar*>()->actions());
  tool->addSeparator();
  add(tool, tr("S&maller"), "tool.smaller",
      [this] { tools_->tool().change_size(1.0 / tool_step); });
  add(tool, tr("&Larger"), "tool.larger", [this] { tools_->tool().change_size(tool_step); });
  add(tool, tr("&Thinner"), "tool.weaker",
      [this] { tools_->tool().change_strength(1.0 / tool_step); });
  add(tool, tr("&Denser"), "tool.stronger", [this] { tools_->tool().change_strength(tool_step); });

  add_fog_menu(*menuBar(), document_, *views_);

  QMenu* time = menuBar()->addMenu(tr("T&ime"));
  add(time, tr("&Play or Pause"), "time.play",
      [this] { timeline_->is_playing() ? timeline_->stop() : timeline_->play(); });
  add(time, tr("&Next Frame"), "time.next",
      [this] { timeline_->set_frame(timeline_->frame() + 1); });
  add(time, tr("P&revious Frame"), "time.previous",
      [this] { timeline_->set_frame(timeline_->frame() - 1); });
  add(time, tr("&First Frame"), "time.first", [this] { timeline_->set_frame(timeline_->first()); });
  time->addSeparator();
  add(time, tr("Set &Keyframe"), "time.set_key", [this] { timeline_bar_->set_key(); });
  add(time, tr("&Bake Particles to Gaussians"), "",
      [this] { freeze_particles(document_, timeline_->time()); });
  add(time, tr("&Remove Sequences"), "",
      [this] { set_scene_part(document_, Sequences{}, tr("Remove sequences")); });

  QMenu* view = menuBar()->addMenu(tr("&View"));
  add(view, tr("Frame &All"), "view.frame_all",
      [this] { views_->active().camera_controller().frame_all(); });
  add(view, tr("&Frame Selection"), "view.frame_selection",
      [this] { views_->active().camera_controller().frame_selection(); });
  add(view, tr("&Scene Camera"), "view.scene_camera",
      [this] { viewport_->camera_controller().look_through_scene_camera(); });
  add(view, tr("&Look Through Light"), "light.look_through", [this] { look_through_light(); });
  add(view, tr("Set Scene Camera &to View"), "view.store_camera",
      [this] { set_scene_camera(document_, viewport_->camera(), tr("Set scene camera to view")); });
  view->addActions(camera_actions_);
  view->addSeparator();
  QAction* four = add(view, tr("F&our Views"), "view.four",
                      [this] { views_->show_four(!views_->shows_four()); });
  four->setCheckable(true);
  add_ground_grid_action(*view, document_, *views_);
  view->addSeparator();
  add(view, tr("Exposure &Up"), "view.exposure_up", [this] { change_exposure(0.5); });
  add(view, tr("Exposure &Down"), "view.exposure_down", [this] { change_exposure(-0.5); });
  fill_mode_menu(view->addMenu(tr("S&how")));
  fill_quality_menu(*view->addMenu(tr("&Quality")), *views_, *findChild<PerformancePanel*>());
  QMenu* color = view->addMenu(tr("&Color"));
  color->setObjectName("color_menu");
  fill_color_menu(*color, views_->color(),
                  [this](const QString& message) { show_status(message); });
  fill_backend_menu(view->addMenu(tr("&Render Device")));
  fill_navigation_menu(view->addMenu(tr("&Navigation")));
  fill_theme_menu(view->addMenu(tr("&Theme")));
  QAction* overlays = add(view, tr("&Handles and Outlines"), "view.overlays",
                          [this] { views_->show_overlays(!views_->shows_overlays()); });
  overlays->setCheckable(true);
  overlays->setChecked(true);
  view->addSeparator();
  fill_layout_menu(*view->addMenu(tr("La&youts")), *this, saveState());
  for (QDockWidget* dock : findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());

  QMenu* render = menuBar()->addMenu(tr("&Render"));
  fill_render_menu(render);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Manual"), "help.manual", [this] {
    const QString error = open_manual(manual_folder());
    if (!error.isEmpty()) message_bar_->show_error(error);
  });
  add(help, tr("&Keyboard Shortcuts"), "help.keys",
      [this, file, edit, adding, select, tool, time, view, render] {
        show_keys(this, file->actions() + edit->actions() + adding->actions() + select->actions() +
                            tool->actions() + time->actions() + view->actions() +
                            render->actions());
      });
  add(help, tr("&About Brume"), "", [this] { show_about(this); });
}

void MainWindow::show_preferences() {
  if (auto* shown = findChild<Preferences*>()) return shown->activateWindow();
  auto* preferences = new Preferences(*autosave_, this);
  for (const auto& [name, title] :
       {std::pair{"theme", tr("Theme")}, std::pair{"navigation", tr("Mouse buttons")},
        std::pair{"backend", tr("Render device")}, std::pair{"airlight", tr("Quality")}}) {
    preferences->add_choice(title, name, *findChild<QActionGroup*>(name));
  }
  preferences->show();
}

void MainWindow::isolate_selection() {
  if (!document_.hidden().empty()) {
    document_.hide({});
    return;
  }
  if (document_.selection().empty()) return;
  std::vector<GaussianId> others;
  for (const GaussianId id : document_.medium().ids()) {
    if (!document_.is_selected(id)) others.push_back(id);
  }
  document_.hide(std::move(others));
}

void MainWindow::fill_mode_menu(QMenu* menu) {
  auto* group = new QActionGroup(this);
  for (const ViewMode mode : view_modes) {
    QAction* action = group->addAction(view_mode_title(mode));
    action->setCheckable(true);
    action->setChecked(mode == viewport_->frames().mode());
    connect(action, &QAction::triggered, this,
            [this, mode] { views_->active().frames().set_mode(mode); });
    connect(views_, &ViewGrid::mode_changed, action,
            [this, action, mode] { action->setChecked(mode == views_->active().frames().mode()); });
  }
  menu->addActions(group->actions());
  menu->addSeparator();
  QAction* next = menu->addAction(tr("&Next"));
  next->setObjectName("view.next_mode");
  next->setShortcuts(keys_of("view.next_mode"));
  // Elsewhere Tab goes from field to field.
  next->setShortcutContext(Qt::WidgetShortcut);
  viewport_->addAction(next);
  connect(views_, &ViewGrid::pane_made, next, [next](Viewport* pane) { pane->addAction(next); });
  connect(next, &QAction::triggered, this, [this] {
    Viewport& view = views_->active();
    view.frames().set_mode(next_view_mode(view.frames().mode()));
    show_status(view_mode_title(view.frames().mode()));
  });
}

void MainWindow::fill_backend_menu(QMenu* menu) {
  const QString remembered = QSettings().value(backend_key).toString();
  auto* group = new QActionGroup(this);
  group->setObjectName("backend");
  const auto add = [&](const char* name, const QString& text, Backend backend) {
    if (remembered == name) views_->set_backend(backend);
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setObjectName(QString("backend_") + name);
    action->setChecked(views_->backend() == backend);
    connect(action, &QAction::triggered, this, [this, name, backend] {
      fallback_.clear();
      views_->set_backend(backend);
      QSettings().setValue(backend_key, name);
    });
  };
  add("auto", tr("&Auto: OpenGL if there is a GPU"), Backend::auto_);
  add("cpu", tr("&CPU"), Backend::cpu);
  add("gl", tr("&OpenGL"), Backend::gl);
  menu->addActions(group->actions());
}

void MainWindow::fill_navigation_menu(QMenu* menu) {
  auto* group = new QActionGroup(this);
  group->setObjectName("navigation");
  const int remembered = QSettings().value(navigation_key).toInt();
  const auto add = [&](const char* name, const QString& text, NavigationPreset preset) {
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setObjectName(QString("navigation_") + name);
    if (remembered == static_cast<int>(preset)) views_->set_navigation(preset);
    action->setChecked(remembered == static_cast<int>(preset));
    connect(action, &QAction::triggered, this, [this, preset] {
      views_->set_navigation(preset);
      QSettings().setValue(navigation_key, static_cast<int>(preset));
    });
  };
  add("brume", tr("&Brume: middle button, or Alt"), NavigationPreset::brume);
  add("blender", tr("Like B&lender: middle button, Shift, Ctrl"), NavigationPreset::blender);
  add("maya", tr("Like &Maya: Alt and a button"), NavigationPreset::maya);
  menu->addActions(group->actions());
}

void MainWindow::fill_theme_menu(QMenu* menu) {
  auto* group = new QActionGroup(this);
  group->setObjectName("theme");
  const auto add = [&](const char* name, const QString& text, Theme theme) {
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setObjectName(QString("theme_") + name);
    action->setChecked(brume::theme() == theme);
    connect(action, &QAction::triggered, this, [theme] { set_theme(theme); });
  };
  add("dark", tr("&Dark"), Theme::dark);
  add("light", tr("&Light"), Theme::light);
  menu->addActions(group->actions());
}

}  // namespace brume
