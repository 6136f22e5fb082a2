#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "brume/scene.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"
#include "core/io/scene/scene_budget.h"
#include "core/io/scene/scene_document.h"
#include "core/io/scene/scene_references.h"

namespace brume {

// A light as scene files have it.
Light read_light(JsonContext& context, JsonObject& object, SceneReferences& references,
                 SceneBudget& budget, UnknownKeys& unknown_keys);
// The same in return, but for `on` and its keyframes. `text_of`: what is written for a file.
using FileText = std::function<std::string(const std::filesystem::path& file)>;
Json light_to_json(const Light& light, const FileText& text_of);

}  // namespace brume
