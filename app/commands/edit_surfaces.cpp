#include "app/commands/edit_surfaces.h"

#include <QHash>
#include <array>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/paths.h"

namespace brume {
namespace {

QString own_name(const Surface& surface) {
  if (!surface.name.empty()) return QString::fromStdString(surface.name);
  return surface.primitive ? primitive_title(surface.primitive->shape)
                           : to_qstring(surface.mesh_file.filename());
}

QString surface_name(const Document& document, std::size_t index) {
  return surface_names(document.scene().surfaces).at(static_cast<int>(index));
}

}  // namespace

QString primitive_title(Primitive::Shape shape) {
  static constexpr std::array titles{
      QT_TRANSLATE_NOOP("undo", "Plane"), QT_TRANSLATE_NOOP("undo", "Box"),
      QT_TRANSLATE_NOOP("undo", "Sphere"), QT_TRANSLATE_NOOP("undo", "Cylinder")};
  return undo_text(titles.at(static_cast<std::size_t>(shape)));
}

QStringList surface_names(const Surfaces& surfaces) {
  QStringList names;
  QHash<QString, int> counts;
  for (const Surface& surface : surfaces) {
    const QString name = own_name(surface);
    const int count = ++counts[name];
    names << (count == 1 ? name : QString("%1 (%2)").arg(name).arg(count));
  }
  return names;
}

void delete_surface(Document& document, std::size_t index) {
  Surfaces surfaces = document.scene().surfaces;
  if (index >= surfaces.size()) return;
  const QString name = surface_name(document, index);
  surfaces.erase(surfaces.begin() + static_cast<std::ptrdiff_t>(index));
  set_scene_part(document, std::move(surfaces), undo_text("Delete %1").arg(name));
}

void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change) {
  Surfaces surfaces = document.scene().surfaces;
  if (index >= surfaces.size()) return;
  change(surfaces[index]);
  set_scene_part(document, std::move(surfaces), verb.arg(surface_name(document, index)), merge_id);
}

}  // namespace brume
