#pragma once

#include <filesystem>
#include <vector>

#include "core/io/scene/scene_document.h"

namespace brume {

// Calls visit(path) for each referenced file and visit(sequence) for each sequence, except
// medium.file.
template <class SceneOrConst, class Visit>
void visit_files(SceneOrConst& scene, Visit visit) {
  for (auto& light : scene.lights) {
    if (light.profile.content) visit(light.profile.file);
  }
  for (auto& surface : scene.surfaces) {
    if (!surface.primitive) visit(surface.mesh_file);
    if (surface.material.type == Material::Type::measured) visit(surface.material.file);
  }
  if (scene.environment) visit(scene.environment->file);
  for (auto& sequence : scene.sequences) visit(sequence);
}

// All files referenced by a loaded scene; may contain duplicates.
std::vector<std::filesystem::path> files_of(const SceneDocument& document);

}  // namespace brume
