#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "core/scene/fields/field.h"
#include "tests/tools/malformed_scenes.h"

namespace brume {

template <class F>
std::string good_value(const F& field) {
  const std::string number = quoted_text(field.domain.nearest(1.0));
  std::string list = number;
  for (int k = 1; k < components<typename F::Value>; ++k) list += ", " + number;
  return components<typename F::Value> > 1 ? "[" + list + "]" : number;
}

// What is no value of a field: of the wrong kind, length and size.
template <class F>
std::vector<std::string> malformed_values(const F& field) {
  using Value = typename F::Value;
  if (std::is_same_v<Value, bool>) return {"0", "\"true\"", "null", "[]", "{}"};
  if (std::is_integral_v<Value>) return {"\"1\"", "null", "true", "[1]", "{}", "0.5", "1e30"};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& [low, high, allowed, open] = field.domain;
  const std::string below = quoted_text(open ? low : std::nextafter(low, -infinity));
  const std::string above = quoted_text(open ? high : std::nextafter(high, infinity));
  constexpr int count = components<Value>;
  if (count == 1) return {"\"1\"", "null", "true", "[1]", "{}", below, above};
  const std::string good = quoted_text(field.domain.nearest(1.0));
  const auto list = [&good](int length, int index, const std::string& bad) {
    std::string text;
    for (int k = 0; k < length; ++k) text += (k > 0 ? ", " : "[") + (k == index ? bad : good);
    return text + "]";
  };
  return {"1",
          "\"1 2 3\"",
          "null",
          "true",
          "{\"x\": 1}",
          list(count - 1, -1, {}),
          list(count + 1, -1, {}),
          list(count, 1, "null"),
          list(count, 0, below),
          list(count, count - 1, above)};
}

// What the message about a malformed value has to name as allowed: the domain if the value is a
// number outside of it, which the last two are.
template <class F>
std::string allowed_of(const F& field, std::size_t index, std::size_t count) {
  const bool is_real = !std::is_integral_v<typename F::Value>;
  return is_real && index + 2 >= count ? field.domain.allowed : "";
}

// Every value of an object, and keyframes of it. `place` is that of the object,
// `scene_with(members)` a scene with such an object.
template <class Owner>
std::vector<MalformedCase> malformed_fields(const std::string& place, auto&& scene_with) {
  std::vector<MalformedCase> all;
  visit_fields<Owner>([&]<class F>(const F& field) {
    const std::string name = field.info.name;
    std::string others;
    visit_fields<Owner>([&](const auto& other) {
      if (!other.info.is_required || other.info.name == name) return;
      others += "\"" + std::string(other.info.name) + "\": " + good_value(other) + ", ";
    });
    const std::vector<std::string> bad_values = malformed_values(field);
    for (std::size_t i = 0; i < bad_values.size(); ++i) {
      const std::string& bad = bad_values[i];
      const auto add = [&](const std::string& members, const std::string& member) {
        all.push_back({place + " with " + members,
                       scene_with(others + members),
                       place + "." + member,
                       {"; allowed: " + allowed_of(field, i, bad_values.size())}});
      };
      add("\"" + name + "\": " + bad, name);
      if (!F::can_have_keys) continue;
      // A value that has to be there; only one with an optional value has keyframes of it.
      const bool is_needed = field.info.is_required || may_be_absent<typename F::Value>;
      add((is_needed ? "\"" + name + "\": " + good_value(field) + ", " : "") + "\"keys\": {\"" +
              name + "\": [{\"time\": 0, \"value\": " + bad + "}]}",
          "keys." + name + "[0].value");
    }
    if (field.info.is_required) {
      all.push_back({place + " without " + name,
                     scene_with(others + "\"x\": 0"),
                     place + "." + name,
                     {"missing"}});
    }
  });
  return all;
}

}  // namespace brume
