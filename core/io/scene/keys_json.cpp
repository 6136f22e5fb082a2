#include "core/io/scene/keys_json.h"

#include <type_traits>

#include "brume/limits.h"
#include "core/io/scene/scene_names.h"

namespace brume {

Json to_json(double value) {
  return value;
}

Json to_json(const glm::dvec2& v) {
  return Json::array({v.x, v.y});
}

Json to_json(const glm::dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json to_json(const glm::dquat& q) {
  return Json::array({q.w, q.x, q.y, q.z});
}

namespace {

void read(JsonObject& object, const char* name, const NumberDomain& domain, double& value) {
  value = object.number(name, domain, {});
}

void read(JsonObject& object, const char* name, const NumberDomain& domain, glm::dvec2& value) {
  value = object.pair(name, domain, {});
}

void read(JsonObject& object, const char* name, const NumberDomain& domain, glm::dvec3& value) {
  value = object.vector(name, domain, {});
}

template <class T>
void read_tangent(JsonObject& object, const char* name, std::optional<T>& slope) {
  if (object.find(name) != nullptr) read(object, name, domain::slope, slope.emplace());
}

template <class T>
Key<T> read_key(JsonContext& context, const Json& json, const JsonPath& path,
                const NumberDomain& domain, UnknownKeys& unknown_keys) {
  JsonObject object(context, json, path);
  Key<T> key;
  key.time = object.number("time", domain::seconds, {});
  if constexpr (std::is_same_v<T, glm::dquat>) {
    key.value = read_unit_quaternion(context, object.required("value"), object.path_of("value"));
  } else {
    read(object, "value", domain, key.value);
    read_tangent(object, "in", key.in);
    read_tangent(object, "out", key.out);
    key.aligned = object.boolean("aligned", key.aligned);
  }
  key.interpolation = static_cast<Interpolation>(
      object.choice("interpolation", scene_names::interpolations, std::size_t{0}));
  unknown_keys.add(key.id, "", object.unknown_keys());
  return key;
}

}  // namespace

template <class T>
void read_keys(JsonContext& context, JsonObject& object, const char* name,
               const NumberDomain& domain, Keys<T>& keys, UnknownKeys& unknown_keys) {
  const Json::array_t& elements = object.array(name, limits::keys_of_value);
  const JsonPath path = object.path_of(name);
  keys.reserve(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const JsonPath element = path.element(i);
    keys.push_back(read_key<T>(context, elements[i], element, domain, unknown_keys));
    if (i > 0 && !(keys[i].time - keys[i - 1].time >= min_key_distance)) {
      context.fail(element.member("time"), "found " + quoted_text(keys[i].time) + " after " +
                                               quoted_text(keys[i - 1].time) +
                                               "; allowed: times that increase by at least 1e-6");
    }
  }
}

template <class T>
Json keys_to_json(const Keys<T>& keys, const UnknownKeys& unknown_keys) {
  Json array = Json::array();
  for (const Key<T>& key : keys) {
    Json entry{{"time", key.time}, {"value", to_json(key.value)}};
    if (key.interpolation != Interpolation::smooth) {
      entry["interpolation"] =
          scene_names::interpolations[static_cast<std::size_t>(key.interpolation)];
    }
    if constexpr (!std::is_same_v<T, glm::dquat>) {
      if (key.in) entry["in"] = to_json(*key.in);
      if (key.out) entry["out"] = to_json(*key.out);
      if (key.aligned) entry["aligned"] = true;
    }
    add_unknown_keys(entry, unknown_keys.of(key.id, ""));
    array.push_back(std::move(entry));
  }
  return array;
}

#define INSTANTIATE(T)                                                                           \
  template void read_keys(JsonContext&, JsonObject&, const char*, const NumberDomain&, Keys<T>&, \
                          UnknownKeys&);                                                         \
  template Json keys_to_json(const Keys<T>&, const UnknownKeys&);
INSTANTIATE(double)
INSTANTIATE(glm::dvec2)
INSTANTIATE(glm::dvec3)
INSTANTIATE(glm::dquat)
#undef INSTANTIATE

}  // namespace brume
