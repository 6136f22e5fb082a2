#pragma once

#include "core/io/json_reader.h"
#include "core/scene/keys.h"

namespace brume {

// The keys of one value: the array `name` of a `keys` object, none where it is absent. Each has a
// time later than the one before by least_key_distance, and a value in the domain.
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<double>& keys);
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<glm::dvec3>& keys);

Json keys_to_json(const Keys<double>& keys);
Json keys_to_json(const Keys<glm::dvec3>& keys);

}  // namespace brume
