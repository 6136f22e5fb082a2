#pragma once

#include <string>

#include "brume/scene.h"
#include "core/io/scene/keys_json.h"

namespace brume {

// A light as scene files have it, but for `on` and its keyframes.
// `profile`: the text for the file of its profile.
Json light_to_json(const Light& light, const std::string& profile);

}  // namespace brume
