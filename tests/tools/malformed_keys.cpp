#include "core/scene/fields/material_fields.h"
#include "tests/tools/malformed_fields.h"

namespace brume {

std::vector<MalformedCase> malformed_keys() {
  using Values = std::vector<const char*>;
  std::vector<MalformedCase> all;
  const auto add = [&all](const std::string& value, const std::string& key,
                          const std::string& place) {
    all.push_back({"a surface's keyframe of " + value + " " + key,
                   scene_with_surface(R"("mesh": "good.obj", "material": {"type": "phong"},
                     "keys": {")" + value +
                                      R"(": [{"time": 0, )" + key + "}]}"),
                   "surfaces[1].keys." + value + "[0]." + place});
  };
  const Values no_numbers{"null", "1", "\"1\"", "[1, 2]", "[1, 2, \"3\"]", "[1, 2, 1e300]"};
  const Values no_rotation{
      "null", "1", "[1, 0, 0]", "[0, 0, 0, 0]", "[2, 0, 0, 0]", "[1, 0, 0, 1e300]"};
  const Values no_length{"null", "[1]", "0", "-1", "1e300"};
  const std::vector<std::pair<std::string, const Values&>> values{
      {"translate", no_numbers}, {"rotate", no_rotation}, {"scale", no_length}};
  for (const auto& [name, bad_values] : values) {
    add(name, R"("interpolation": "linear")", "value");
    for (const std::string bad : bad_values) add(name, R"("value": )" + bad, "value");
  }
  visit_fields<Material>([&](const auto& field) {
    for (const std::string& bad : malformed_values(field)) {
      add(field.info.name, R"("value": )" + bad, "value");
      all.push_back({"a material with " + std::string(field.info.name) + " " + bad,
                     scene_with_surface(R"("mesh": "good.obj", "material": {"type": "phong", ")" +
                                        std::string(field.info.name) + "\": " + bad + "}"),
                     "surfaces[1].material." + std::string(field.info.name),
                     {"; allowed: "}});
    }
  });
  for (const std::string tangent : {"in", "out"}) {
    for (const std::string bad : {"null", "[1]", "\"0\"", "true", "1e31", "-1e300"}) {
      add("scale", R"("value": 1, ")" + tangent + "\": " + bad, tangent);
    }
    for (const std::string bad : no_numbers) {
      add("translate", R"("value": [0, 0, 0], ")" + tangent + "\": " + bad, tangent);
    }
  }
  for (const std::string bad : {"null", "1", "\"yes\""}) {
    add("scale", R"("value": 1, "aligned": )" + bad, "aligned");
  }
  add("scale", R"("value": 1, "interpolation": "free")", "interpolation");
  all.back().said = {"\"smooth\", \"linear\", \"constant\""};
  for (const std::string bad : {"null", "1", "[]", "\"none\""}) {
    all.push_back({"a surface with keys " + bad,
                   scene_with_surface(R"("mesh": "good.obj", "keys": )" + bad),
                   "surfaces[1].keys"});
  }
  all.push_back({"a surface's keyframes in no order",
                 scene_with_surface(R"("mesh": "good.obj", "keys": {"rotate": [
                   {"time": 1, "value": [1, 0, 0, 0]}, {"time": 1, "value": [0, 1, 0, 0]}]})"),
                 "surfaces[1].keys.rotate[1].time",
                 {"1 after 1"}});
  return all;
}

}  // namespace brume
