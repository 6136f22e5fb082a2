#include "app/commands/edit_surfaces.h"

#include <QHash>
#include <algorithm>
#include <limits>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "core/limits.h"
#include "core/math/rounded.h"
#include "core/scene/mesh_arrays.h"

namespace brume {
namespace {

QString surface_name(const Document& document, std::size_t index) {
  return surface_names(document.scene().surfaces).at(static_cast<int>(index));
}

double world_width(const Surface& surface) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const glm::dvec3& p : world_points(surface)) {
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  }
  return std::max(high - low, 0.0);
}

}  // namespace

QStringList surface_names(const Surfaces& surfaces) {
  QStringList names;
  QHash<QString, int> counts;
  for (const Surface& surface : surfaces) {
    const QString name = to_qstring(surface.mesh_file.filename());
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

void duplicate_surface(Document& document, std::size_t index) {
  Surfaces surfaces = document.scene().surfaces;
  if (index >= surfaces.size() || surfaces.size() >= limits::surfaces) return;
  Surface copy = surfaces[index];
  copy.translate.x += rounded(1.1 * world_width(copy), 3);
  surfaces.push_back(std::move(copy));
  set_scene_part(document, std::move(surfaces),
                 undo_text("Duplicate %1").arg(surface_name(document, index)));
}

void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change) {
  Surfaces surfaces = document.scene().surfaces;
  if (index >= surfaces.size()) return;
  change(surfaces[index]);
  set_scene_part(document, std::move(surfaces), verb.arg(surface_name(document, index)), merge_id);
}

}  // namespace brume
