#pragma once

#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"
#include "core/scene/fields/field.h"

namespace brume {

// Values of core/scene/fields in JSON, without their keyframes (keys_json.h).

inline void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                       double& value) {
  value = object.number(name, domain, value);
}
inline void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                       glm::dvec3& value) {
  value = object.vector(name, domain, value);
}
inline void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                       std::optional<double>& value) {
  if (object.find(name) != nullptr) value = object.number(name, domain, {});
}

// Values that an object lacks stay as they are.
template <class Owner>
void read_fields(JsonObject& object, Owner& owner) {
  visit_fields<Owner>([&](const auto& field) {
    read_value(object, field.info.name, field.domain, field.of(owner));
  });
}

// All values that is_set() of.
template <class Owner>
void write_fields(Json& object, const Owner& owner, const auto& keys) {
  visit_present(owner, [&](const auto& field, const auto& value) {
    if (is_set(field, owner, keys)) object[field.info.name] = to_json(value);
  });
}

}  // namespace brume
