#pragma once

#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_document.h"
#include "core/io/scene/scene_references.h"

namespace brume {

// `output` of a scene file. Its file need not be there.
Output read_output(JsonContext& context, JsonObject& object, const SceneReferences& references,
                   UnknownKeys& unknown_keys);

// The output of a scene file in `directory`; an empty object if there is nothing to say.
Json output_to_json(const Output& output, const UnknownKeys& unknown_keys,
                    const std::filesystem::path& directory);

}  // namespace brume
