#include "app/window/menus/object_menu.h"

#include <QDockWidget>
#include <QMainWindow>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_cameras.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/object_titles.h"
#include "app/import/scene_import.h"
#include "app/panels/forms/light_panel.h"
#include "app/panels/lists/outliner.h"
#include "app/tools/selection/click_target.h"
#include "app/view/floor.h"
#include "app/view/surface_picker.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/rows.h"
#include "app/window/file_jobs.h"
#include "app/window/menus/menu_action.h"
#include "brume/limits.h"
#include "core/math/rounded.h"

namespace brume {

ObjectMenu::ObjectMenu(const Workspace& work, FileJobs& jobs, QMainWindow& window)
    : QObject(&window), work_(work), jobs_(jobs), window_(window) {
  connect(&work_.views, &ViewGrid::menu_asked, this, &ObjectMenu::show_view_menu);
}

void ObjectMenu::fill_add_menu(QMenu& menu) {
  struct Shape {
    const char* name;
    Primitive::Shape shape;
  };
  for (const Shape& entry :
       {Shape{"add.plane", Primitive::Shape::plane}, Shape{"add.box", Primitive::Shape::box},
        Shape{"add.sphere", Primitive::Shape::sphere},
        Shape{"add.cylinder", Primitive::Shape::cylinder}}) {
    add_action(&menu, primitive_title(entry.shape), entry.name, this,
               [this, shape = entry.shape] { add_primitive(shape); });
  }
  add_action(&menu, tr("&Mesh from File…"), "", this, [this] { jobs_.import().ask(); });
  menu.addSeparator();
  const auto add_light_action = [&](const QString& text, const char* name,
                                    const Light::Kind& kind) {
    add_action(&menu, text, name, this,
               [this, kind] { window_.findChild<LightPanel*>()->add(kind); });
  };
  add_light_action(tr("&Point Light"), "light.point", light::Point());
  add_light_action(tr("&Spot"), "light.spot", light::Spot());
  add_light_action(tr("S&un"), "light.directional", light::Directional());
  add_light_action(tr("&Rectangle Light"), "light.rectangle", light::Rectangle());
  add_light_action(tr("&Disc Light"), "light.disk", light::Disk());
  add_light_action(tr("Sp&here Light"), "light.sphere", light::Sphere());
  menu.addSeparator();
  add_action(&menu, tr("&Camera"), "add.camera", this, [this] {
    if (!add_camera(work_.document, work_.views.perspective().camera())) return;
    work_.document.set_object(std::nullopt);
    window_.findChild<Outliner*>()->show_camera_in_use();
  });
  add_action(&menu, tr("&Gaussian"), "edit.add_gaussian", this, [this] { add_gaussian_in_view(); });
  add_action(&menu, tr("&Emitter"), "add.emitter", this, [this] {
    Viewport& view = work_.views.pointed();
    add_emitter(work_.document, view.place_under_mouse(born_radius(view.distance())),
                view.distance());
    auto* panel = window_.findChild<QDockWidget*>("emitters_dock");
    panel->show();
    panel->raise();
  });
}

// A seventh as large as what is looked at is far, on what is below that, or else on the ground.
void ObjectMenu::add_primitive(Primitive::Shape shape) {
  View& view = work_.views.active();
  const double size = std::max(rounded(0.15 * view.distance(), 1), limits::min_length);
  const bool is_plane = shape == Primitive::Shape::plane;
  Surface surface;
  surface.primitive = Primitive{shape, glm::dvec3(is_plane ? 4.0 * size : size)};
  surface.mesh = mesh_of(*surface.primitive);
  const glm::dvec3 target = view.camera().target;
  const auto below = view.surfaces().hit(target + glm::dvec3(0.0, size, 0.0), {0.0, -1.0, 0.0});
  surface.translate = {rounded(target.x, 3),
                       below ? below->position.y : std::min(0.0, rounded(target.y, 3)),
                       rounded(target.z, 3)};
  if (!is_plane) surface.translate.y += 0.5 * size;
  jobs_.import().add_surfaces({surface}, tr("Add %1").arg(primitive_title(shape)));
}

void ObjectMenu::add_gaussian_in_view() {
  Viewport& view = work_.views.pointed();
  const double radius = rounded(0.12 * std::max(view.distance(), 1e-6), 3);
  // Optical depth 1 through the center: sqrt(pi) * radius * density.
  const double density = rounded(1.0 / (std::sqrt(std::numbers::pi) * radius), 3);
  add_gaussian(work_.document,
               {.center = view.place_under_mouse(radius), .radius = radius, .density = density});
}

void ObjectMenu::rename_object() {
  if (!work_.document.object())
    return work_.show_status(tr("Select a light, emitter or surface to rename it"));
  auto* dock = window_.findChild<QDockWidget*>("outliner");
  dock->show();
  dock->raise();
  window_.findChild<Outliner*>()->rename_current();
}

void ObjectMenu::drop_object() {
  const auto& object = work_.document.object();
  if (!object || object->kind != ObjectRef::Kind::surface)
    return work_.show_status(tr("Select a surface to drop it on the floor"));
  const Scene& scene = work_.document.scene();
  if (object->index < scene.surfaces.size() && scene.surfaces[object->index].locked)
    return work_.show_status(
        tr("%1 is locked. Unlock it to drop it").arg(object_title(scene, *object)));
  const double rise =
      rise_to_floor(scene, work_.views.active().surfaces(), {object->index, std::size_t{1}});
  change_surface(work_.document, object->index, tr("Drop %1 on the floor"), no_merge,
                 [rise](Surface& surface) { surface.translate.y += rise; });
}

void ObjectMenu::show_view_menu(Viewport& view, QPointF position) {
  const ClickTarget target = click_target(work_.document, view, position);
  // Selected Gaussians stay: the menu is about all of them.
  if (target.object) {
    work_.document.set_object(target.object);
  } else if (target.gaussian && !work_.document.is_selected(*target.gaussian)) {
    select_gaussians(work_.document, {*target.gaussian});
  }
  auto* menu = named(new QMenu(&view), "view_menu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  view.set_asked(*menu, position);
  const auto add = [this, menu](std::initializer_list<const char*> names) {
    for (const char* name : names) {
      auto* action = name ? window_.findChild<QAction*>(name) : nullptr;
      if (action) menu->addAction(action);
    }
    menu->addSeparator();
  };
  if (const auto& object = work_.document.object()) {
    menu->addSection(object_title(work_.document.scene(), *object));
    add({"tool.move", "tool.rotate", "tool.scale"});
    const char* save = object->kind == ObjectRef::Kind::emitter ? nullptr : "asset.save";
    add({"edit.rename", "edit.duplicate", "edit.drop", "select.hide", "select.lock", save,
         "edit.delete"});
  } else if (!work_.document.selection().empty()) {
    menu->addSection(
        tr("%n Gaussian(s)", nullptr, static_cast<int>(work_.document.selection().size())));
    add({"tool.move", "tool.rotate", "tool.scale"});
    add({"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "select.hide", "select.lock",
         "asset.save", "edit.delete"});
  } else {
    add({"edit.paste", "select.all"});
  }
  menu->addMenu(window_.findChild<QMenu*>("add_menu"));
  menu->addMenu(window_.findChild<QMenu*>("fog_menu"));
  menu->addSeparator();
  add({"view.frame_selection", "view.frame_all"});
  menu->popup(view.mapToGlobal(position).toPoint());
}

}  // namespace brume
