#include "app/document/object_titles.h"

#include <QCoreApplication>
#include <QHash>
#include <algorithm>
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

QString numbered(const QString& name, std::ptrdiff_t count) {
  return count == 1 ? name : QString("%1 (%2)").arg(name).arg(count);
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

QString surface_name(const Surfaces& surfaces, std::size_t index) {
  const QString name = own_name(surfaces[index]);
  const auto end = surfaces.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  return numbered(name, std::count_if(surfaces.begin(), end, [&name](const Surface& surface) {
                    return own_name(surface) == name;
                  }));
}

QStringList surface_names(const Surfaces& surfaces) {
  QStringList names;
  QHash<QString, int> counts;
  for (const Surface& surface : surfaces) {
    const QString name = own_name(surface);
    names << numbered(name, ++counts[name]);
  }
  return names;
}

}  // namespace brume
