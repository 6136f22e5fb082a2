#pragma once

#include "brume/keys.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_document.h"
#include "core/number_domain.h"

namespace brume {

// Keyframes of one value: the array `name` of a `keys` object; empty if missing. Times increase by
// at least min_key_distance, values lie in the domain; rotations are unit quaternions, without
// tangents.
template <class T>
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<T>& keys, UnknownKeys& unknown_keys);

// The member `keys` of an object: those of the values that visit_all(visit) goes through; see
// core/scene/animation/animation.h. Its unknown keys.
std::string read_keys_member(JsonContext& context, JsonObject& owner, UnknownKeys& unknown_keys,
                             auto&& visit_all) {
  auto object = owner.find_object("keys");
  if (!object) return {};
  visit_all([&](const char* name, const auto&, auto& keys, const NumberDomain& domain) {
    read_keys(context, *object, name, domain, keys, unknown_keys);
  });
  return object->unknown_keys();
}

Json to_json(double value);
Json to_json(const glm::dvec2& v);
Json to_json(const glm::dvec3& v);
Json to_json(const glm::dquat& q);  // w x y z
template <class T>
Json keys_to_json(const Keys<T>& keys, const UnknownKeys& unknown_keys);

// Adds the member `keys` with the keys of the values that visit_all(visit) goes through, and with
// `unknown` ones, if any.
void add_keys(Json& object, const UnknownKeys& unknown_keys, const std::string& unknown,
              auto&& visit_all) {
  Json all = Json::object();
  visit_all([&](const char* name, const auto&, const auto& keys, const NumberDomain&) {
    if (!keys.empty()) all[name] = keys_to_json(keys, unknown_keys);
  });
  add_unknown_keys(all, unknown);
  if (!all.empty()) object["keys"] = std::move(all);
}

// Reads the keyframes of an object with an id, and keeps the unknown keys of both; `part`: the path
// within that object of one that has no id.
void read_rest(JsonContext& context, JsonObject& object, ObjectId& id, UnknownKeys& unknown_keys,
               auto&& visit_all, const std::string& part = "") {
  unknown_keys.add(id, part.empty() ? "keys" : part + ".keys",
                   read_keys_member(context, object, unknown_keys, visit_all));
  unknown_keys.add(id, part, object.unknown_keys());
}

// Adds keys and unknown keys to an object.
void add_rest(Json& object, ObjectId id, const UnknownKeys& unknown_keys, auto&& visit_all,
              const std::string& part = "") {
  add_keys(object, unknown_keys, unknown_keys.of(id, part.empty() ? "keys" : part + ".keys"),
           visit_all);
  add_unknown_keys(object, unknown_keys.of(id, part));
}

}  // namespace brume
