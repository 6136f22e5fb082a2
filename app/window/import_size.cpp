#include "app/window/import_size.h"

#include <QApplication>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/object_titles.h"
#include "app/document/text/number_text.h"
#include "app/view/camera/bounds.h"
#include "app/view/floor.h"
#include "app/view/surface_picker.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/interface_settings.h"
#include "app/window/pages/message_bar.h"
#include "core/math/rounded.h"

namespace brume {
namespace {

// Things imported into a scene are usually between a twentieth of what is looked at and all of it:
// these are ten times as much.
constexpr double too_large = 10.0;
constexpr double too_small = 1.0 / 200.0;
constexpr double fitting = 0.25;

double largest_side(const MeshBox& box) {
  const glm::dvec3 sides = box.high - box.low;
  return std::max({sides.x, sides.y, sides.z});
}

// About how much of the scene is looked at; 0: there was nothing else.
double seen_size(const View& view, const Scene& scene, std::size_t first) {
  double radius = 0.0;
  if (const auto sphere = bounding_sphere(std::span(scene.surfaces).first(first))) {
    radius = sphere->radius;
  }
  if (const auto sphere = bounding_sphere(scene.medium, scene.medium.ids())) {
    radius = std::max(radius, sphere->radius);
  }
  return std::min(view.distance(), 1.5 * radius);
}

}  // namespace

ImportSize::ImportSize(const Workspace& work, QObject* parent) : QObject(parent), work_(work) {
  on_change(work_.document, Change::scene | Change::part, this, [this] {
    if (!message_.isEmpty() && work_.messages.message() == message_ && !is_there()) {
      work_.messages.hide();
    }
  });
}

void ImportSize::show(std::size_t first, bool is_framed) {
  const Scene& scene = work_.document.scene();
  View& view = work_.views.active();
  first_ = first;
  added_.assign(scene.surfaces.begin() + static_cast<std::ptrdiff_t>(first), scene.surfaces.end());
  size_ = seen_size(view, scene, first);
  target_ = view.camera().target;
  if (!is_framed) frame();
  const double side = largest_side(box_of(scene, range()));
  const bool suits = side < too_large * size_ && side > too_small * size_;
  message_.clear();
  if (size_ > 0.0 && !suits) offer();
}

SurfaceRange ImportSize::range() const {
  return {first_, added_.size()};
}

void ImportSize::frame() {
  const auto sphere =
      bounding_sphere(std::span(work_.document.scene().surfaces).subspan(first_, added_.size()));
  CameraController& camera = work_.views.active().camera_controller();
  if (sphere && !camera.looks_through_scene_camera()) camera.frame(*sphere);
}

bool ImportSize::is_there() const {
  const Surfaces& surfaces = work_.document.scene().surfaces;
  return surfaces.size() >= first_ + added_.size() &&
         std::ranges::equal(added_, std::span(surfaces).subspan(first_, added_.size()), {},
                            &Surface::mesh_file, &Surface::mesh_file);
}

void ImportSize::offer() {
  const Scene& scene = work_.document.scene();
  const MeshBox box = box_of(scene, range());
  const auto text_of = [](double length) { return number_text(length, 3); };
  const glm::dvec3 sides = box.high - box.low;
  const QString& length_unit = InterfaceSettings::instance().length_unit();
  const QString last = (text_of(sides.z) + ' ' + length_unit).trimmed();
  message_ = tr("%1 measures %2 × %3 × %4; what is looked at is about %5 across.")
                 .arg(surface_names(scene.surfaces).at(static_cast<int>(first_)), text_of(sides.x),
                      text_of(sides.y), last, text_of(size_));
  const auto unit = [this](const QString& name, const char* object_name, double length) {
    return MessageBar::Offer{name, object_name, [this, name, length] { set_unit(name, length); }};
  };
  work_.messages.show_offers(message_, {{tr("Fit"), "import_fit", [this] { fit(); }},
                                        unit(tr("mm"), "import_mm", 0.001),
                                        unit(tr("cm"), "import_cm", 0.01),
                                        unit(tr("m"), "import_m", 1.0),
                                        unit(tr("inch"), "import_inch", 0.0254),
                                        {tr("Drop on Floor"), "import_drop", [this] { drop(); }}});
}

void ImportSize::change(const QString& text, const std::function<void(Surface&)>& how) {
  if (!is_there()) return;
  Surfaces surfaces = work_.document.scene().surfaces;
  std::ranges::for_each(std::span(surfaces).subspan(first_, added_.size()), how);
  set_scene_part(
      work_.document, std::move(surfaces),
      text.arg(surface_names(work_.document.scene().surfaces).at(static_cast<int>(first_))));
  frame();
  offer();
}

void ImportSize::set_unit(const QString& name, double length) {
  std::size_t k = 0;
  change(tr("Read %1 in ") + name, [&](Surface& surface) {
    surface.scale = added_[k].scale * length;
    surface.translate = added_[k].translate * length;
    ++k;
  });
}

// The surfaces go to the floor where the view looked before.
void ImportSize::fit() {
  if (!is_there()) return;
  const Scene& scene = work_.document.scene();
  const MeshBox box = box_of(scene, range());
  const double factor = rounded(fitting * size_ / std::max(largest_side(box), 1e-12), 2);
  const glm::dvec3 middle = 0.5 * (box.low + box.high);
  const double floor = floor_below(scene, work_.views.active().surfaces(), target_, range());
  const glm::dvec3 foot(target_.x, floor, target_.z);
  const glm::dvec3 shift = foot - factor * glm::dvec3(middle.x, box.low.y, middle.z);
  change(tr("Fit %1"), [&](Surface& surface) {
    surface.scale *= factor;
    surface.translate = factor * surface.translate + shift;
  });
}

void ImportSize::drop() {
  if (!is_there()) return;
  const Scene& scene = work_.document.scene();
  const double rise = rise_to_floor(scene, work_.views.active().surfaces(), range());
  change(tr("Drop %1 on the floor"), [rise](Surface& surface) { surface.translate.y += rise; });
}

}  // namespace brume
