#pragma once

#include <cmath>
#include <limits>

#include "core/scene/fields/field.h"
#include "tests/tools/malformed_scenes.h"

namespace brume {

// What is no value of a field: of the wrong kind, length and size.
template <class F>
std::vector<std::string> malformed_values(const F& field) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& [low, high, allowed, open] = field.domain;
  const std::string below = quoted_text(open ? low : std::nextafter(low, -infinity));
  const std::string above = quoted_text(open ? high : std::nextafter(high, infinity));
  if (!std::is_same_v<typename F::Value, glm::dvec3>) {
    return {"\"1\"", "null", "true", "[1]", "{}", below, above};
  }
  const std::string good = quoted_text(field.domain.nearest(1.0));
  return {"1",
          "\"1 2 3\"",
          "null",
          "true",
          "{\"x\": 1}",
          "[" + good + ", " + good + "]",
          "[" + good + ", " + good + ", " + good + ", " + good + "]",
          "[" + good + ", null, " + good + "]",
          "[" + below + ", " + good + ", " + good + "]",
          "[" + good + ", " + good + ", " + above + "]"};
}

// Every value of an object, and keyframes of it. `scene_with(members)`: with such an object.
template <class Owner>
std::vector<MalformedCase> malformed_fields(const std::string& object, auto&& scene_with) {
  std::vector<MalformedCase> all;
  visit_fields<Owner>([&]<class F>(const F& field) {
    const std::string name = field.info.name;
    for (const std::string& bad : malformed_values(field)) {
      const auto add = [&](const std::string& members, const std::string& place) {
        all.push_back({object + " with " + members,
                       scene_with(members),
                       object + "." + place,
                       {"; allowed: "}});
      };
      add("\"" + name + "\": " + bad, name);
      if (!F::can_have_keys) continue;
      // Only one with an optional value has keyframes of it.
      const std::string value =
          may_be_absent<typename F::Value>
              ? "\"" + name + "\": " + quoted_text(field.domain.nearest(1.0)) + ", "
              : "";
      add(value + "\"keys\": {\"" + name + "\": [{\"time\": 0, \"value\": " + bad + "}]}",
          "keys." + name + "[0].value");
    }
  });
  return all;
}

}  // namespace brume
