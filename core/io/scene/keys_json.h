#pragma once

#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_document.h"
#include "core/scene/keys.h"

namespace brume {

// Keyframes of one value: the array `name` of a `keys` object; empty if missing. Times increase by
// at least min_key_distance, values lie in the domain.
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<double>& keys, UnknownKeys& unknown_keys);
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<glm::dvec2>& keys, UnknownKeys& unknown_keys);
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<glm::dvec3>& keys, UnknownKeys& unknown_keys);

Json to_json(const glm::dvec2& v);
Json to_json(const glm::dvec3& v);
Json keys_to_json(const Keys<double>& keys, const UnknownKeys& unknown_keys);
Json keys_to_json(const Keys<glm::dvec2>& keys, const UnknownKeys& unknown_keys);
Json keys_to_json(const Keys<glm::dvec3>& keys, const UnknownKeys& unknown_keys);

}  // namespace brume
