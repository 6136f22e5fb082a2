#pragma once

#include <cstdint>
#include <type_traits>

#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"
#include "core/scene/fields/description.h"
#include "core/scene/fields/field.h"

namespace brume {

// Values of core/scene/fields in JSON, without their keyframes (keys_json.h).

inline void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                       double& value) {
  value = object.number(name, domain, value);
}
inline void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                       glm::dvec2& value) {
  value = object.pair(name, domain, value);
}
inline void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                       glm::dvec3& value) {
  value = object.vector(name, domain, value);
}
inline void read_value(JsonObject& object, const char* name, const NumberDomain&, bool& value) {
  value = object.boolean(name, value);
}
inline void read_value(JsonObject& object, const char* name, const NumberDomain&,
                       std::int64_t& value) {
  value = object.integer(name, INT64_MIN, INT64_MAX, value);
}
template <class T>
void read_value(JsonObject& object, const char* name, const NumberDomain& domain,
                std::optional<T>& value) {
  if (object.find(name) != nullptr) read_value(object, name, domain, value.emplace());
}

// Values that an object lacks stay as they are.
template <class Owner>
void read_fields(JsonObject& object, Owner& owner) {
  visit_fields_of(owner, [&](const auto& field) {
    if (field.info.is_required) static_cast<void>(object.required(field.info.name));
    read_value(object, field.info.name, field.domain, field.of(owner));
  });
  visit_fields<Owner>([&]<class F>(const F& field) {
    const char* const name = field.info.name;
    const FieldInfo* const other = replacement(field, owner);
    if (!other) return;
    if (object.find(name) != nullptr && (field.info.is_always_saved || !is_usual(field, owner))) {
      object.fail(other->name, found_beside(name));
    }
    if constexpr (F::can_have_keys) {
      const Json* const keys = object.peek("keys");
      if (keys != nullptr && keys->contains(name)) {
        object.fail(other->name, found_beside(std::string("keys.") + name));
      }
    }
  });
}

inline Json value_to_json(const auto& value) {
  if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
    return value;
  } else {
    return to_json(value);
  }
}

// All values that is_set() of.
template <class Owner>
void write_fields(Json& object, const Owner& owner, const auto& keys) {
  visit_present(owner, [&](const auto& field, const auto& value) {
    if (is_set(field, owner, keys)) object[field.info.name] = value_to_json(value);
  });
}

}  // namespace brume
