#include "app/window/menus/main_menu.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <algorithm>

#include "app/assets/asset_panel.h"
#include "app/commands/gaussians/clipboard.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_keys.h"
#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"
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
#include "app/widgets/rows.h"
#include "app/window/dialogs/help_windows.h"
#include "app/window/dialogs/preferences.h"
#include "app/window/file_jobs.h"
#include "app/window/frame_output.h"
#include "app/window/menus/command_search.h"
#include "app/window/menus/menu_action.h"
#include "app/window/menus/menus.h"
#include "app/window/menus/object_menu.h"
#include "app/window/pages/message_bar.h"
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

// The actions of a menu and of its submenus.
QList<QAction*> all_actions(const QMenu& menu) {
  QList<QAction*> actions;
  for (QAction* action : menu.actions()) {
    if (const QMenu* submenu = action->menu()) {
      actions += all_actions(*submenu);
    } else {
      actions << action;
    }
  }
  return actions;
}

}  // namespace

MainMenu::MainMenu(const Workspace& work, const Parts& parts, QMainWindow& window)
    : QObject(&window), work_(work), parts_(parts), window_(window) {
  QList<QMenu*> menus;
  const auto add_menu = [this, &menus](const QString& title) {
    return menus.emplace_back(window_.menuBar()->addMenu(title));
  };
  fill_file_menu(add_menu(tr("&File")));
  fill_edit_menu(add_menu(tr("&Edit")));
  QMenu* adding = add_menu(tr("&Add"));
  adding->setObjectName("add_menu");
  parts_.objects.fill_add_menu(*adding);
  fill_select_menu(add_menu(tr("&Select")));
  fill_tool_menu(add_menu(tr("&Tool")));
  add_fog_menu(*window_.menuBar(), work_.document, work_.views);
  fill_time_menu(add_menu(tr("T&ime")));
  fill_view_menu(add_menu(tr("&View")));
  parts_.output.fill_menu(*add_menu(tr("&Render")));
  fill_help_menu(window_.menuBar()->addMenu(tr("&Help")), menus);
}

QAction* MainMenu::add(QMenu* menu, const QString& text, const char* name, auto react) {
  return add_action(menu, text, name, this, react);
}

void MainMenu::fill_file_menu(QMenu* menu) {
  add(menu, tr("&New"), "file.new", [this] { work_.files.create(); });
  add(menu, tr("&Open…"), "file.open", [this] { work_.files.open(); });
  QMenu* recent = menu->addMenu(tr("Open &Recent"));
  show_large_icons(*recent);
  connect(recent, &QMenu::aboutToShow, this,
          [this, recent] { work_.files.fill_recent_menu(*recent); });
  add(menu, tr("Start Pa&ge"), "file.start_page", [this] { parts_.start_page.open(); });
  menu->addSeparator();
  add(menu, tr("&Save"), "file.save", [this] { work_.files.save(); });
  add(menu, tr("Save &As…"), "file.save_as", [this] { work_.files.save_as(); });
  menu->addSeparator();
  add(menu, tr("&Import…"), "file.import", [this] { parts_.jobs.import().ask(); });
  add(menu, tr("Import Se&quence…"), "", [this] { parts_.jobs.import().ask_sequence(); });
  menu->addSeparator();
  add(menu, tr("&Export Picture or Animation…"), "file.export",
      [this] { parts_.output.show_output(); });
  add(menu, tr("Export Me&dium…"), "", [this] { parts_.jobs.export_medium(); });
  add(menu, tr("Save as Asse&t…"), "asset.save",
      [this] { window_.findChild<AssetPanel*>()->save_chosen(); });
  add(menu, tr("&Gather into Folder…"), "", [this] { parts_.jobs.gather(); });
  menu->addSeparator();
  add(menu, tr("&Quit"), "file.quit", [this] { window_.close(); });
}

void MainMenu::fill_edit_menu(QMenu* menu) {
  QAction* undo = work_.document.undo_stack().createUndoAction(&window_, tr("&Undo"));
  undo->setObjectName("edit.undo");
  undo->setShortcuts(keys_of("edit.undo"));
  undo->setIconText(tr("Undo"));
  QAction* redo = work_.document.undo_stack().createRedoAction(&window_, tr("&Redo"));
  redo->setObjectName("edit.redo");
  redo->setShortcuts(keys_of("edit.redo"));
  redo->setIconText(tr("Redo"));
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  add(menu, tr("Fi&nd Command…"), "edit.find_command", [this] {
    auto* search = new CommandSearch(*window_.menuBar(), &window_);
    Viewport& view = work_.views.pointed();
    // The command is carried out when the dialog is gone.
    auto* place = new QObject(&window_);
    connect(search, &QObject::destroyed, place, &QObject::deleteLater, Qt::QueuedConnection);
    view.set_asked(*place, view.mouse_position());
    search->open();
  });
  add(menu, tr("Prefere&nces…"), "edit.preferences", [this] { show_preferences(); });
  menu->addSeparator();
  add(menu, tr("Cu&t"), "edit.cut", [this] { cut_selection(work_.document); });
  add(menu, tr("&Copy"), "edit.copy", [this] { copy_selection(work_.document); });
  add(menu, tr("&Paste"), "edit.paste", [this] {
    paste_gaussians(work_.document, work_.views.pointed().place_under_mouse(clipboard_radius()));
  });
  add(menu, tr("Paste in Pl&ace"), "edit.paste_in_place",
      [this] { paste_gaussians(work_.document, std::nullopt); });
  add(menu, tr("D&uplicate"), "edit.duplicate", [this] {
    if (work_.document.object()) return duplicate_object(work_.document, *work_.document.object());
    duplicate_selection(work_.document,
                        work_.views.active().shift_on_film({duplicate_shift, duplicate_shift}));
  });
  add(menu, tr("&Delete"), "edit.delete", [this] { delete_selected(); });
  add(menu, tr("Simplif&y…"), "edit.simplify", [this] { parts_.jobs.simplify(); });
  add(menu, tr("Drop on Fl&oor"), "edit.drop", [this] { parts_.objects.drop_object(); });
  QAction* rename =
      add(menu, tr("Rena&me"), "edit.rename", [this] { parts_.objects.rename_object(); });
  // Elsewhere F2 edits the cell of a table.
  rename->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  work_.views.addAction(rename);
  window_.findChild<Outliner*>()->addAction(rename);
}

void MainMenu::fill_select_menu(QMenu* menu) {
  add(menu, tr("&All"), "select.all", [this] { select_all(work_.document); });
  add(menu, tr("&None"), "select.none", [this] { select_gaussians(work_.document, {}); });
  add(menu, tr("&Invert"), "select.invert", [this] { invert_selection(work_.document); });
  add(menu, tr("&Grow"), "select.grow", [this] { grow_selection(work_.document); });
  add(menu, tr("Shrin&k"), "select.shrink", [this] { shrink_selection(work_.document); });
  QMenu* similar = menu->addMenu(tr("Si&milar"));
  for (const GaussianAttribute field :
       {GaussianAttribute::radius, GaussianAttribute::density, GaussianAttribute::albedo,
        GaussianAttribute::emission, GaussianAttribute::elongation}) {
    add(similar, tr("Similar %1").arg(attribute_title(field)), "",
        [this, field] { select_similar(work_.document, field); });
  }
  add(similar, tr("Same Group"), "", [this] { select_same_groups(work_.document); });
  menu->addSeparator();
  add(menu, tr("Gr&oup Selection"), "select.group", [this] { group_selection(work_.document); });
  add(menu, tr("Ungroup S&election"), "select.ungroup",
      [this] { ungroup_selection(work_.document); });
  QMenu* to_group = menu->addMenu(tr("Mo&ve to Group"));
  to_group->setObjectName("move_to_group");
  connect(to_group, &QMenu::aboutToShow, this,
          [this, to_group] { fill_group_menu(*to_group, work_.document); });
  menu->addSeparator();
  add(menu, tr("&Hide"), "select.hide", [this] {
    if (work_.document.object())
      return show_object(work_.document, *work_.document.object(), false);
    work_.document.hide(joined(work_.document.hidden(), work_.document.selection()));
  });
  add(menu, tr("Isola&te"), "select.isolate", [this] { isolate_selection(); });
  add(menu, tr("&Show All"), "select.show_all", [this] { work_.document.hide({}); });
  add(menu, tr("&Lock"), "select.lock", [this] {
    if (work_.document.object()) return lock_object(work_.document, *work_.document.object(), true);
    work_.document.lock(joined(work_.document.locked(), work_.document.selection()));
  });
  add(menu, tr("&Unlock All"), "select.unlock_all", [this] { work_.document.lock({}); });
}

void MainMenu::fill_tool_menu(QMenu* menu) {
  menu->addActions(window_.findChild<ToolBar*>()->actions());
  menu->addSeparator();
  add(menu, tr("S&maller"), "tool.smaller",
      [this] { work_.tools.tool().change_size(1.0 / tool_step); });
  add(menu, tr("&Larger"), "tool.larger", [this] { work_.tools.tool().change_size(tool_step); });
  add(menu, tr("&Thinner"), "tool.weaker",
      [this] { work_.tools.tool().change_strength(1.0 / tool_step); });
  add(menu, tr("&Denser"), "tool.stronger",
      [this] { work_.tools.tool().change_strength(tool_step); });
}

void MainMenu::fill_time_menu(QMenu* menu) {
  add(menu, tr("&Play or Pause"), "time.play",
      [this] { work_.timeline.is_playing() ? work_.timeline.stop() : work_.timeline.play(); });
  add(menu, tr("&Next Frame"), "time.next",
      [this] { work_.timeline.set_frame(work_.timeline.frame() + 1); });
  add(menu, tr("P&revious Frame"), "time.previous",
      [this] { work_.timeline.set_frame(work_.timeline.frame() - 1); });
  add(menu, tr("&First Frame"), "time.first",
      [this] { work_.timeline.set_frame(work_.timeline.first()); });
  menu->addSeparator();
  add(menu, tr("Set &Keyframe"), "time.set_key", [this] { parts_.timeline_bar.set_key(); });
  add(menu, tr("&Bake Particles to Gaussians"), "",
      [this] { freeze_particles(work_.document, work_.timeline.time()); });
  add(menu, tr("&Remove Sequences"), "",
      [this] { set_scene_part(work_.document, Sequences{}, tr("Remove sequences")); });
}

void MainMenu::fill_view_menu(QMenu* menu) {
  add(menu, tr("Frame &All"), "view.frame_all",
      [this] { work_.views.active().camera_controller().frame_all(); });
  add(menu, tr("&Frame Selection"), "view.frame_selection",
      [this] { work_.views.active().camera_controller().frame_selection(); });
  QMenu* camera = menu->addMenu(tr("&Camera"));
  add(camera, tr("&Scene Camera"), "view.scene_camera",
      [this] { work_.views.perspective().camera_controller().look_through_scene_camera(); });
  add(camera, tr("&Look Through Light"), "light.look_through", [this] { look_through_light(); });
  add(camera, tr("Set Scene Camera &to View"), "view.store_camera", [this] {
    set_scene_camera(work_.document, work_.views.perspective().camera(),
                     tr("Set scene camera to view"));
  });
  camera->addActions(parts_.output.camera_actions());
  menu->addSeparator();
  QAction* four = add(menu, tr("F&our Views"), "view.four",
                      [this] { work_.views.show_four(!work_.views.shows_four()); });
  four->setCheckable(true);
  menu->addSeparator();
  QMenu* exposure = menu->addMenu(tr("&Exposure"));
  add(exposure, tr("Exposure &Up"), "view.exposure_up", [this] { change_exposure(0.5); });
  add(exposure, tr("Exposure &Down"), "view.exposure_down", [this] { change_exposure(-0.5); });
  fill_mode_menu(menu->addMenu(tr("S&how")));
  QMenu* quality = menu->addMenu(tr("&Quality"));
  fill_quality_menu(*quality, work_.views, *window_.findChild<PerformancePanel*>());
  QMenu* color = menu->addMenu(tr("&Colour"));
  color->setObjectName("color_menu");
  fill_color_menu(*color, work_.views.color(), work_.show_status);
  fill_backend_menu(menu->addMenu(tr("&Render Device")));
  fill_navigation_menu(menu->addMenu(tr("&Navigation")));
  fill_theme_menu(menu->addMenu(tr("&Theme")));
  QMenu* overlays = menu->addMenu(tr("O&verlays"));
  QAction* handles = add(overlays, tr("&Handles and Outlines"), "view.overlays",
                         [this] { work_.views.show_overlays(!work_.views.shows_overlays()); });
  handles->setCheckable(true);
  handles->setChecked(true);
  add_ground_grid_action(*overlays, work_.document, work_.views);
  overlays->addActions(parts_.output.guide_actions());
  work_.views.set_header_menus(
      {.quality = quality, .color = color, .camera = camera, .overlays = overlays});
  menu->addSeparator();
  fill_layout_menu(*menu->addMenu(tr("La&youts")), window_, window_.saveState());
  QMenu* panels = menu->addMenu(tr("&Panels"));
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>())
    panels->addAction(dock->toggleViewAction());
}

void MainMenu::fill_help_menu(QMenu* menu, const QList<QMenu*>& others) {
  add(menu, tr("&Manual"), "help.manual", [this] {
    const QString error = open_manual(manual_folder());
    if (!error.isEmpty()) work_.messages.show_error(error);
  });
  add(menu, tr("&Keyboard Shortcuts"), "help.keys", [this, others] {
    QList<QAction*> actions;
    for (const QMenu* other : others) actions += all_actions(*other);
    show_keys(&window_, actions);
  });
  add(menu, tr("&About Brume"), "", [this] { show_about(&window_); });
}

void MainMenu::fill_mode_menu(QMenu* menu) {
  auto* group = new QActionGroup(&window_);
  for (const ViewMode mode : view_modes) {
    QAction* action =
        add_choice(group, view_mode_title(mode), mode == work_.views.perspective().frames().mode(),
                   [this, mode] { work_.views.active().frames().set_mode(mode); });
    connect(&work_.views, &ViewGrid::mode_changed, action, [this, action, mode] {
      action->setChecked(mode == work_.views.active().frames().mode());
    });
  }
  menu->addActions(group->actions());
  menu->addSeparator();
  QAction* next = menu->addAction(tr("&Next"));
  next->setObjectName("view.next_mode");
  next->setShortcuts(keys_of("view.next_mode"));
  // Elsewhere Tab goes from field to field.
  next->setShortcutContext(Qt::WidgetShortcut);
  work_.views.perspective().addAction(next);
  connect(&work_.views, &ViewGrid::pane_made, next,
          [next](Viewport* pane) { pane->addAction(next); });
  connect(next, &QAction::triggered, this, [this] {
    Viewport& view = work_.views.active();
    view.frames().set_mode(next_view_mode(view.frames().mode()));
    work_.show_status(view_mode_title(view.frames().mode()));
  });
}

void MainMenu::fill_backend_menu(QMenu* menu) {
  const QString remembered = QSettings().value(backend_key).toString();
  auto* group = named(new QActionGroup(&window_), "backend");
  const auto add = [&](const char* name, const QString& text, Backend backend) {
    if (remembered == name) work_.views.set_backend(backend);
    named(add_choice(group, text, work_.views.backend() == backend,
                     [this, name, backend] {
                       work_.views.set_backend(backend);
                       QSettings().setValue(backend_key, name);
                     }),
          QString("backend_") + name);
  };
  add("auto", tr("&Auto: OpenGL if there is a GPU"), Backend::auto_);
  add("cpu", tr("&CPU"), Backend::cpu);
  add("gl", tr("&OpenGL"), Backend::gl);
  menu->addActions(group->actions());
}

void MainMenu::fill_navigation_menu(QMenu* menu) {
  auto* group = named(new QActionGroup(&window_), "navigation");
  const int remembered = QSettings().value(navigation_key).toInt();
  const auto add = [&](const char* name, const QString& text, NavigationPreset preset) {
    const bool is_remembered = remembered == static_cast<int>(preset);
    if (is_remembered) work_.views.set_navigation(preset);
    named(add_choice(group, text, is_remembered,
                     [this, preset] {
                       work_.views.set_navigation(preset);
                       QSettings().setValue(navigation_key, static_cast<int>(preset));
                     }),
          QString("navigation_") + name);
  };
  add("brume", tr("&Brume: middle button, or Alt"), NavigationPreset::brume);
  add("blender", tr("Like B&lender: middle button, Shift, Ctrl"), NavigationPreset::blender);
  add("maya", tr("Like &Maya: Alt and a button"), NavigationPreset::maya);
  menu->addActions(group->actions());
}

void MainMenu::fill_theme_menu(QMenu* menu) {
  auto* group = named(new QActionGroup(&window_), "theme");
  const auto add = [&](const char* name, const QString& text, Theme theme) {
    named(add_choice(group, text, brume::theme() == theme, [theme] { set_theme(theme); }),
          QString("theme_") + name);
  };
  add("dark", tr("&Dark"), Theme::dark);
  add("light", tr("&Light"), Theme::light);
  menu->addActions(group->actions());
}

void MainMenu::delete_selected() {
  if (const auto object = work_.document.object()) {
    delete_object(work_.document, *object);
    if (!object->node) work_.document.set_object(std::nullopt);  // a second key deletes no other
    return;
  }
  delete_selection(work_.document, tr("Delete"));
}

void MainMenu::isolate_selection() {
  if (!work_.document.hidden().empty()) {
    work_.document.hide({});
    return;
  }
  if (work_.document.selection().empty()) return;
  std::vector<GaussianId> others;
  for (const GaussianId id : work_.document.medium().ids()) {
    if (!work_.document.is_selected(id)) others.push_back(id);
  }
  work_.document.hide(std::move(others));
}

void MainMenu::look_through_light() {
  const Scene& scene = work_.document.scene();
  if (work_.document.active_light() >= scene.lights.size()) return;
  const Light& light = scene.lights[work_.document.active_light()];
  work_.views.perspective().camera_controller().set_camera(
      camera_at(light, LitRegion::of(scene), work_.views.perspective().camera().target));
}

void MainMenu::change_exposure(double stops) {
  Viewport& view = work_.views.active();
  view.frames().set_exposure(
      std::clamp(view.frames().exposure() + stops, -max_exposure, max_exposure));
  work_.show_status(tr("Exposure %1 stops").arg(fixed_text(view.frames().exposure(), 1)));
}

void MainMenu::show_preferences() {
  if (auto* shown = window_.findChild<Preferences*>()) return shown->activateWindow();
  auto* preferences = new Preferences(parts_.autosave, &window_);
  for (const auto& [name, title] :
       {std::pair{"theme", tr("Theme")}, std::pair{"navigation", tr("Mouse buttons")},
        std::pair{"backend", tr("Render device")}, std::pair{"airlight", tr("Quality")}}) {
    preferences->add_choice(title, name, *window_.findChild<QActionGroup*>(name));
  }
  preferences->show();
}

}  // namespace brume
