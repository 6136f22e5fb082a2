#pragma once

#include <string>

#include "core/io/scene/keys_json.h"
#include "core/scene/scene.h"

namespace brume {

// A light as scene files have it, but for `on` and its keyframes.
// `profile`: the text for the file of its profile.
Json light_to_json(const Light& light, const std::string& profile);

}  // namespace brume
