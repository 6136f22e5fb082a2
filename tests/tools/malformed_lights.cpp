#include <utility>

#include "tests/tools/malformed_scenes.h"

namespace brume {

std::vector<MalformedCase> malformed_lights() {
  using Values = std::vector<const char*>;
  const Values no_vector{"1",
                         "\"1 2 3\"",
                         "null",
                         "true",
                         "[1, 2]",
                         "[1, 2, 3, 4]",
                         "[1, \"2\", 3]",
                         "{\"x\": 1}",
                         "[1, null, 3]",
                         "[1e300, 0, 0]"};
  const Values no_number{"\"1\"", "null", "true", "[1]", "{}", "-1", "1e300", "-1e-300"};
  Values no_angle = no_number;
  no_angle.push_back("0");
  const Values no_boolean{"0", "\"true\"", "null", "[]", "{}"};
  struct Key {
    const char* name;
    const char* good;  // its value where another one is bad
    const Values& bad;
    bool required = true;
  };
  const Key position{"position", "[1, 2, 3]", no_vector};
  const Key direction{"direction", "[0, -1, 0]", no_vector};
  const Key radiance{"radiance", "[1, 1, 1]", no_vector};
  const Key radius{"radius", "0.5", no_number};
  const Key two_sided{"two_sided", "true", no_boolean, false};
  const std::vector<std::pair<const char*, std::vector<Key>>> types{
      {"point", {position, {"intensity", "[1, 1, 1]", no_vector, false}}},
      {"spot",
       {position,
        direction,
        {"intensity", "[1, 1, 1]", no_vector, false},
        {"inner_angle", "10", no_number, false},
        {"outer_angle", "20", no_angle, false}}},
      {"directional",
       {direction,
        {"irradiance", "[1, 1, 1]", no_vector},
        {"angular_diameter", "1", no_number, false}}},
      {"rectangle",
       {position,
        direction,
        {"up", "[0, 0, 1]", no_vector, false},
        {"width", "1", no_number},
        {"height", "1", no_number},
        radiance,
        two_sided}},
      {"disk", {position, direction, radius, radiance, two_sided}},
      {"sphere", {position, radius, radiance, two_sided}}};
  std::vector<MalformedCase> all;
  for (const auto& [type, keys] : types) {
    for (const Key& key : keys) {
      const auto add = [&](const char* value) {
        std::string members = std::string(R"("type": ")") + type + '"';
        for (const Key& other : keys) {
          const char* text = other.name == key.name ? value : other.good;
          if (text) members += std::string(", \"") + other.name + "\": " + text;
        }
        all.push_back({std::string(type) + " with " + key.name + " " + (value ? value : "missing"),
                       scene_with_light(members),
                       std::string("lights[0].") + key.name,
                       {value ? "allowed" : "missing"}});
      };
      for (const char* bad : key.bad) add(bad);
      if (key.required) add(nullptr);
    }
  }
  for (const char* type : {"point", "spot"}) {
    for (const char* bad : {"1", "null", "[]", "{}", "\"\"", "\"none.ies\"", "\"..\"", "true"}) {
      const std::string members =
          std::string(R"("type": ")") + type +
          R"(", "position": [0, 1, 0], "direction": [0, -1, 0], "profile": )";
      all.push_back({std::string(type) + " with profile " + bad, scene_with_light(members + bad),
                     "lights[0].profile"});
    }
  }
  for (const char* type : {"\"area\"", "\"Point\"", "\"\"", "1", "null", "[\"point\"]"}) {
    all.push_back({std::string("a light of type ") + type,
                   scene_with_light(std::string(R"("position": [0, 0, 0], "type": )") + type),
                   "lights[0].type",
                   {"allowed"}});
  }
  return all;
}

}  // namespace brume
