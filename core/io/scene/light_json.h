#pragma once

#include "core/io/scene/keys_json.h"
#include "core/scene/scene.h"

namespace brume {

// A light as scene files have it, but for `on` and its keyframes.
Json light_to_json(const Light& light);

}  // namespace brume
