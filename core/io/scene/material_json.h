#pragma once

#include <filesystem>

#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_budget.h"
#include "core/io/scene/scene_document.h"
#include "core/io/scene/scene_references.h"

namespace brume {

// The material of a surface as scene files have it.
void read_material(JsonContext& context, JsonObject& object, SceneReferences& references,
                   SceneBudget& budget, UnknownKeys& unknown_keys, Surface& surface);
// The materials that a surface with an imported scene has in place of its file's, from its object.
void read_materials(JsonContext& context, JsonObject& object, SceneReferences& references,
                    SceneBudget& budget, UnknownKeys& unknown_keys, Surface& surface);
// `directory`: of the scene file.
Json material_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                      const std::filesystem::path& directory);
Json materials_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                       const std::filesystem::path& directory);

}  // namespace brume
