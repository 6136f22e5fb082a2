#pragma once

#include <filesystem>
#include <vector>

#include "core/scene/scene.h"

namespace brume {

// Calls visit(path) for each reference of a scene to a file, and visit(sequence) for each sequence;
// without medium_file, which is shared.
template <class SceneOrConst, class Visit>
void visit_files(SceneOrConst& scene, Visit visit) {
  for (auto& surface : scene.surfaces) {
    visit(surface.mesh_file);
    if (surface.material.type == Material::Type::measured) visit(surface.material.file);
  }
  if (scene.environment) visit(scene.environment->file);
  for (auto& sequence : scene.sequences) visit(sequence);
}

// All files that a loaded scene was read from besides its own; some may be named twice.
std::vector<std::filesystem::path> files_of(const Scene& scene);

}  // namespace brume
