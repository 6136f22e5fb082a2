#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <glm/geometric.hpp>

#include "app/commands/gaussians/add_fog.h"
#include "app/document/document.h"
#include "app/view/camera/bounds.h"
#include "app/view/camera/navigation.h"
#include "app/view/floor.h"
#include "app/view/paint_point.h"
#include "app/view/surface_picker.h"
#include "app/viewport/view_grid.h"
#include "app/window/dialogs/fog_shape_dialog.h"
#include "app/window/menus/menus.h"

namespace brume {
namespace {

constexpr double facing_up = 0.5;      // cosine
constexpr double enough_ground = 0.2;  // share of what is in view

double ground_share(const FindGround& find_ground, const glm::dvec3& around, double size) {
  constexpr int side = 9;
  int found = 0;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      const double x = around.x + size * (2.0 * i / (side - 1) - 1.0);
      const double z = around.z + size * (2.0 * k / (side - 1) - 1.0);
      if (find_ground(x, z)) ++found;
    }
  }
  return static_cast<double>(found) / (side * side);
}

// The place for fog under the mouse, or else in the middle of a view: the surface there if that
// faces up, or else the ground below. The ground is what lies below the height of the eye, so that
// the ceiling of a room is none; where hardly any of it is met, it is the plane of the lowest
// surface, or y = 0.
FogPlace fog_place(const Document& document, View& view) {
  const Camera& camera = view.camera();
  FogPlace place;
  place.eye = camera.eye;
  place.size = view.distance();
  if (const auto sphere = bounding_sphere(document.scene());
      sphere && !document.scene().surfaces.empty()) {
    place.size = std::min(place.size, 1.5 * sphere->radius);
  }
  SurfacePicker& surfaces = view.surfaces();
  const glm::dvec3 down(0.0, -1.0, 0.0);
  const double top = std::max(camera.eye.y, camera.target.y + 0.05 * place.size);
  place.find_ground = [&surfaces, down, top](double x, double z) -> std::optional<double> {
    const auto hit = surfaces.hit({x, top, z}, down);
    return hit ? std::optional(hit->position.y) : std::nullopt;
  };
  if (ground_share(place.find_ground, camera.target, place.size) < enough_ground) {
    place.find_ground = [flat = lowest_surface(document.scene())](double, double) {
      return std::optional(flat);
    };
  }

  // Points far beyond what is looked at, as of a horizon, are no place for it.
  const QPointF mouse = view.mouse_position();
  const auto at_mouse = [&](PaintPlane plane) {
    return paint_point(view, {.plane = plane}, mouse, 0.1 * place.size);
  };
  auto point = at_mouse(PaintPlane::under_mouse);
  if (!point || point->distance > 2.0 * target_distance(camera)) point = at_mouse(PaintPlane::view);
  place.target = point ? point->position : camera.target;
  const auto surface = at_mouse(PaintPlane::surface);
  if (point && point->on_surface && surface->normal.y > facing_up) {
    place.target = surface->position;
  } else {
    place.target.y = place.find_ground(place.target.x, place.target.z).value_or(place.target.y);
  }
  const glm::dvec3 above = place.target + glm::dvec3(0.0, 0.01 * place.size, 0.0);
  if (const auto hit = surfaces.hit(above, {0.0, 1.0, 0.0})) {
    place.headroom = hit->position.y - place.target.y;
  }
  return place;
}

}  // namespace

void add_fog_menu(QMenuBar& bar, Document& document, ViewGrid& views) {
  const auto fog_text = [](const char* text) { return QCoreApplication::translate("Fog", text); };
  QMenu* menu = bar.addMenu(fog_text("F&og"));
  menu->setObjectName("fog_menu");
  menu->setToolTipsVisible(true);
  for (const FogPreset& preset : fog_presets()) {
    QAction* action = menu->addAction(fog_text(preset.title));
    action->setObjectName(preset.name);
    action->setToolTip(fog_text(preset.hint));
    QObject::connect(action, &QAction::triggered, &views, [&document, &views, &preset] {
      add_fog_preset(document, preset, fog_place(document, views.perspective()));
    });
  }
  menu->addSeparator();
  QAction* shape = menu->addAction(fog_text("Add S&hape…"));
  shape->setObjectName("fog.shape");
  shape->setToolTip(fog_text("A box, a sphere or height fog of Gaussians, by numbers"));
  QObject::connect(shape, &QAction::triggered, &views, [&document, &views] {
    auto* dialog =
        new FogShapeDialog(document, fog_place(document, views.perspective()), views.window());
    dialog->show();
  });
}

}  // namespace brume
