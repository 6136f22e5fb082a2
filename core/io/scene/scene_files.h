#pragma once

#include <filesystem>
#include <vector>

#include "core/io/scene/scene_document.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/imported_scene.h"

namespace brume {

// Calls visit(path) for each referenced file, visit(sequence) for each sequence and visit(surface)
// for each with an imported scene, which has more than one file; except medium.file.
template <class SceneOrConst, class Visit>
void visit_files(SceneOrConst& scene, Visit visit) {
  for (auto& light : scene.lights) {
    if (auto* profile = profile_of(light)) visit(profile->file);
    // Without content it is missing.
    if (auto* texture = texture_of(light); texture && texture->content) visit(texture->file);
  }
  for (auto& surface : scene.surfaces) {
    if (surface.copies && !surface.copies->file.empty()) visit(surface.copies->file);
    if (surface.imported) {
      visit(surface);
      continue;
    }
    if (!surface.primitive) visit(surface.mesh_file);
    if (surface.material.type == Material::Type::measured) visit(surface.material.file);
    if (surface.material.type == Material::Type::metallic_roughness) {
      for (auto* texture : textures_of(surface.material.metallic_roughness)) {
        if (texture->content) visit(texture->file);  // else it is missing
      }
    }
  }
  if (scene.environment && !scene.environment->sky) visit(scene.environment->file);
  for (auto& sequence : scene.sequences) visit(sequence);
}

// All files referenced by a loaded scene; may contain duplicates.
std::vector<std::filesystem::path> files_of(const SceneDocument& document);

// Those that are not within `folder`, each once.
std::vector<std::filesystem::path> files_outside(const SceneDocument& document,
                                                 const std::filesystem::path& folder);

}  // namespace brume
