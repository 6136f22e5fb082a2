#pragma once

#include "brume/scene.h"
#include "core/io/scene/keys_json.h"

namespace brume {

// `camera`, the one in use, and `cameras`, the others, of a scene file; each has another name.
void read_cameras(JsonContext& context, JsonObject& root, Scene& scene, UnknownKeys& unknown_keys);

Json camera_to_json(const Scene& scene, const UnknownKeys& unknown_keys);  // the one in use
Json camera_to_json(const NamedCamera& camera, const UnknownKeys& unknown_keys);

}  // namespace brume
