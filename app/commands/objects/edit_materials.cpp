#include "app/commands/objects/edit_materials.h"

#include <algorithm>

#include "app/commands/objects/edit_objects.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace {

auto find_changed(auto& surface, const std::string& name) {
  return std::ranges::find(surface.materials, name, &Material::name);
}

QString text_of(const QString& verb, const MaterialRef& ref) {
  if (ref.name.empty()) return verb;
  return verb.arg(undo_text("%1 of %2").arg(QString::fromStdString(ref.name), "%1"));
}

}  // namespace

const Material* find_material(const Scene& scene, const MaterialRef& ref) {
  if (ref.surface >= scene.surfaces.size()) return nullptr;
  const Surface& surface = scene.surfaces[ref.surface];
  if (!surface.imported) return ref.name.empty() ? &surface.material : nullptr;
  for (const ImportedPart& part : surface.imported->parts) {
    if (part.material.name == ref.name) return &material_of(surface, part);
  }
  return nullptr;
}

bool is_changed(const Scene& scene, const MaterialRef& ref) {
  if (ref.surface >= scene.surfaces.size()) return false;
  const Surface& surface = scene.surfaces[ref.surface];
  return find_changed(surface, ref.name) != surface.materials.end();
}

void change_material(Document& document, const MaterialRef& ref, const QString& verb,
                     MergeId merge_id, const std::function<void(Material&)>& change) {
  const Material* const now = find_material(document.scene(), ref);
  if (!now) return;
  change_surface(document, ref.surface, text_of(verb, ref), merge_id,
                 [&ref, &change, before = *now](Surface& surface) {
                   if (ref.name.empty()) return change(surface.material);
                   auto changed = find_changed(surface, ref.name);
                   if (changed == surface.materials.end()) {
                     changed = surface.materials.insert(changed, before);
                   }
                   change(*changed);
                 });
}

void restore_material(Document& document, const MaterialRef& ref) {
  change_surface(document, ref.surface, text_of(undo_text("Restore %1"), ref), no_merge,
                 [&ref](Surface& surface) {
                   std::erase_if(surface.materials,
                                 [&ref](const Material& m) { return m.name == ref.name; });
                 });
}

}  // namespace brume
