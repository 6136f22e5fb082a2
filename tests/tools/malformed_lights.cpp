
#include "core/scene/fields/light_fields.h"
#include "tests/tools/malformed_fields.h"
#include "tests/tools/malformed_scenes.h"

namespace brume {

std::vector<MalformedCase> malformed_lights() {
  std::vector<MalformedCase> all;
  const auto add_values = [&all]<class Owner>(const std::string& type, const Owner&) {
    const std::vector<MalformedCase> cases =
        malformed_fields<Owner>("lights[0]", [&type](const std::string& members) {
          return scene_with_light("\"type\": " + type + ", " + members);
        });
    all.insert(all.end(), cases.begin(), cases.end());
  };
  visit_light_kinds([&](const LightKindInfo& info, const auto& kind) {
    add_values('"' + std::string(info.name) + '"', kind);
  });
  const std::string point = R"("point", "position": [0, 1, 0])";
  add_values(point, Light());
  add_values(point + R"(, "profile": "good.ies")", LightProfile());
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
