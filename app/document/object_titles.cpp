#include "app/document/object_titles.h"

#include <QCoreApplication>
#include <QHash>
#include <array>

#include "app/document/paths.h"
#include "core/scene/fields/light_fields.h"

namespace brume {
namespace {

QString own_name(const Surface& surface) {
  if (!surface.name.empty()) return QString::fromStdString(surface.name);
  return surface.primitive ? primitive_title(surface.primitive->shape)
                           : to_qstring(surface.mesh_file.filename());
}

}  // namespace

QString light_title(const Light& light, std::size_t index) {
  if (!light.name.empty()) return QString::fromStdString(light.name);
  return QCoreApplication::translate("Undo", kind_info(light).title) + ' ' +
         QString::number(index + 1);
}

QString emitter_title(const Emitter& emitter, std::size_t index) {
  return emitter.name.empty() ? QCoreApplication::translate("Undo", "Emitter %1").arg(index + 1)
                              : QString::fromStdString(emitter.name);
}

QString primitive_title(Primitive::Shape shape) {
  static constexpr std::array titles{
      QT_TRANSLATE_NOOP("Surfaces", "Plane"), QT_TRANSLATE_NOOP("Surfaces", "Box"),
      QT_TRANSLATE_NOOP("Surfaces", "Sphere"), QT_TRANSLATE_NOOP("Surfaces", "Cylinder")};
  return QCoreApplication::translate("Surfaces", titles.at(static_cast<std::size_t>(shape)));
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

}  // namespace brume
