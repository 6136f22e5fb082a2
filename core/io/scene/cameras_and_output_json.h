#pragma once

#include "brume/scene.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"
#include "core/io/scene/scene_document.h"
#include "core/io/scene/scene_references.h"

namespace brume {

// `camera`, the one in use, and `cameras`, the others, of a scene file; each has another name.
void read_cameras(JsonContext& context, JsonObject& root, Scene& scene, UnknownKeys& unknown_keys);

Json camera_to_json(const Scene& scene, const UnknownKeys& unknown_keys);  // the one in use
Json camera_to_json(const NamedCamera& camera, const UnknownKeys& unknown_keys);

// `output` of a scene file. Its file need not be there.
Output read_output(JsonContext& context, JsonObject& object, const SceneReferences& references,
                   UnknownKeys& unknown_keys);

// The output of a scene file in `directory`; an empty object if there is nothing to say.
Json output_to_json(const Output& output, const UnknownKeys& unknown_keys,
                    const std::filesystem::path& directory);

}  // namespace brume
