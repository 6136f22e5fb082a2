#include "app/commands/edit_surfaces.h"

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"

namespace brume {
namespace {

QString surface_name(const Document& document, std::size_t index) {
  return surface_names(document.scene().surfaces).at(static_cast<int>(index));
}

}  // namespace

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
