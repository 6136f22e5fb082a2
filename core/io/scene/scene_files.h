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
  // `left_out`: textures that are no references of their own.
  const auto visit_material = [&visit](auto& material, const auto& left_out) {
    if (material.type == Material::Type::measured) visit(material.file);
    if (material.type != Material::Type::metallic_roughness) return;
    const auto textures = textures_of(material.metallic_roughness);
    for (std::size_t k = 0; k < textures.size(); ++k) {
      // A texture without content is missing.
      if (textures[k]->content && !left_out[k]) visit(textures[k]->file);
    }
  };
  for (auto& surface : scene.surfaces) {
    if (surface.copies && !surface.copies->file.empty()) visit(surface.copies->file);
    if (surface.imported) {
      visit(surface);
      for (auto& material : surface.materials) {
        visit_material(material, are_of_file(*surface.imported, material));
      }
      continue;
    }
    if (!surface.primitive) visit(surface.mesh_file);
    visit_material(surface.material, std::array<bool, texture_has_colors.size()>{});
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
